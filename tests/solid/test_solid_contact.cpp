// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "solid/hex_block.hpp"
#include "solid/square_cavity.hpp"

namespace parison::tests {
namespace {

/// A half space of iron; the normal is out of it.
class Plane : public contact::ToolSurface {
 public:
  Plane(const Vector3& point, const Vector3& normal) : point_(point), normal_(normal) {}
  contact::SurfaceGap gap(const Vector3& at) const override { return {normal_.dot(at - point_), normal_}; }

 private:
  Vector3 point_, normal_;
};

constexpr double radius = 10e-3, slice = 1e-3;  ///< m

/// An eighth of a tube in a square mould whose flats it just touches; thickness over radius `thin`.
struct SquareTube {
  flow::Material material = uniform_glass(1);
  Plane flat{{radius, 0, 0}, {-1, 0, 0}};
  flow::SolidGlass glass;
  flow::SolidProblem problem;

  SquareTube(Index around, double thin, flow::Friction::Law law)
      : glass(glass_of(hex_block(around, 1, 1,
                                 [&](const Vector3& x) -> Vector3 {
                                   const double at = M_PI / 4 * x[0], r = radius * (1 - thin * (1 - x[2]));
                                   return {r * std::cos(at), r * std::sin(at), slice * x[1]};
                                 }),
                       material)) {
    problem.material = &material;
    problem.planes = {
        plane_of(glass.mesh, Vector3::Unit(1)),
        plane_of(glass.mesh, Vector3(-1, 1, 0).normalized()),
        plane_of(glass.mesh, Vector3::Unit(2)),
        {Vector3::Unit(2), nodes_where(glass.mesh, [](const Vector3& x) { return x[2] > slice - 1e-9; })}};
    const double inside = radius * (1 - thin);
    problem.pressures = {
        {faces_where(glass.mesh, [=](const Vector3& x) { return x.head<2>().norm() < inside + 1e-7; }), 1.0}};
    problem.contact_faces =
        faces_where(glass.mesh, [](const Vector3& x) { return x.head<2>().norm() > radius - 1e-7; });
    flow::Friction friction;
    friction.law = law;
    problem.tools = {{&flat, Vector3::Zero(), Vector3::Zero(), friction}};
  }
};

/// Thickness of the corner over the first when the free arc has half its first radius, and the time over that of a
/// membrane.
std::pair<double, double> blown_corner(Index around, double thin, flow::Friction::Law law) {
  SquareTube tube(around, thin, law);
  flow::FlowMatrix matrix(tube.glass.mesh, tube.problem.planes, {});
  const auto corner =
      nodes_where(tube.glass.mesh, [](const Vector3& x) { return std::abs(x[0] - x[1]) < 1e-9 && x[2] < 1e-9; });
  const Index inside = corner.front(), outside = corner.back();  // nodes are numbered outwards
  const double until = 0.5, membrane_time = 0.0984917 * thin * 10;
  double time = 0, last_time = 0, last_radius = 1, last_thickness = 1;
  for (int steps = 0; steps < 200; ++steps) {
    flow::SolidStepLimits limits;
    limits.strain = 0.05;
    limits.landing = 5e-6;
    limits.longest = steps ? 1 : 1e-2 * thin;
    const flow::SolidStep step =
        flow::step_flow(tube.problem, matrix, tube.glass, flow::propose_step(tube.problem, tube.glass, limits));
    EXPECT_TRUE(step.accepted);
    time += step.dt;
    EXPECT_LE(step.volume_error, 1e-9);
    const auto& x = tube.glass.mesh.nodes;
    const double r = (std::sqrt(2) - x[outside].head<2>().norm() / radius) / (std::sqrt(2) - 1);
    const double h = (x[outside] - x[inside]).norm() / (thin * radius);
    if (r < until) {
      const double part = (last_radius - until) / (last_radius - r);
      return {last_thickness + part * (h - last_thickness), (last_time + part * (time - last_time)) / membrane_time};
    }
    last_time = time;
    last_radius = r;
    last_thickness = h;
  }
  return {0, 0};
}

TEST(SolidContact, ABlownSquareTubeThinsTowardsItsCornerAsAMembraneThatSticks) {
  // A membrane has (r/R0)^(4/pi - 1); a wall differs by its thickness over the radius, which two walls tell.
  const auto [thick, thick_time] = blown_corner(48, 0.05, flow::Friction::Law::stick);
  const auto [thin, thin_time] = blown_corner(48, 0.025, flow::Friction::Law::stick);
  fmt::print("thickness {:.5f} {:.5f} to {:.5f} membrane 0.82746; time over the membrane's {:.4f} {:.4f} to {:.4f}\n",
             thick, thin, 2 * thin - thick, thick_time, thin_time, 2 * thin_time - thick_time);
  expect_at_most("corner of a blown square tube, wall to 0", std::abs((2 * thin - thick) / 0.82746 - 1), 0.01);
  expect_at_most("time until then", std::abs(2 * thin_time - thick_time - 1), 0.03);
}

/// A box between planes under gas, on a plane of iron.
struct Box {
  flow::Material material = uniform_glass(1e3);
  Plane floor{{0, 0, 0}, {0, 0, 1}};
  flow::SolidGlass glass = glass_of(hex_block(2, 2, 2,
                                              [](const Vector3& x) -> Vector3 {
                                                return {4e-3 * x[0], 3e-3 * x[1], 2e-3 * x[2]};
                                              }),
                                    material);
  flow::SolidProblem problem;

  Box() {
    problem.material = &material;
    problem.contact_faces = faces_where(glass.mesh, [](const Vector3& x) { return x[2] < 1e-9; });
    problem.pressures = {{faces_where(glass.mesh, [](const Vector3& x) { return x[2] > 2e-3 - 1e-9; }), 5e4}};
    problem.tools = {{&floor, Vector3::Zero(), Vector3::Zero(), {}}};
  }
  /// Nodes do not move in a direction.
  void hold(int axis) {
    problem.planes.push_back({Vector3::Unit(axis), nodes_where(glass.mesh, [](const Vector3&) { return true; })});
  }
};

TEST(SolidContact, AToolIsPressedByWhatPressesTheGlass) {
  Box box;
  box.hold(0);
  box.hold(1);
  flow::FlowMatrix matrix(box.glass.mesh, box.problem.planes, {});
  box.glass.velocity = Eigen::VectorXd::Zero(3 * box.glass.mesh.node_count());
  const auto step = flow::step_flow(box.problem, matrix, box.glass, 1e-3);
  ASSERT_TRUE(step.accepted);
  expect_at_most("force on a tool", std::abs(step.tool_forces[0][2] / (-5e4 * 12e-6) - 1), 1e-6);
  Figure pressure("pressure of contact at a point under an even load");
  for (const auto& point : box.glass.contact) pressure.add(std::abs(point.pressure / 5e4 - 1));
  pressure.at_most(1e-6);
}

TEST(SolidContact, GlassSlidesOnAToolByItsFriction) {
  // Held on top, dragged below: tau = eta v/h = beta (V - v).
  for (const auto law : {flow::Friction::Law::slip, flow::Friction::Law::navier, flow::Friction::Law::stick}) {
    Box box;
    box.hold(1);
    box.hold(2);
    box.problem.fixed = nodes_where(box.glass.mesh, [](const Vector3& x) { return x[2] > 2e-3 - 1e-9; });
    auto& tool = box.problem.tools[0];
    tool.velocity = {0.01, 0, 1e-3};  // a little upwards, so that it presses
    tool.friction.law = law;
    tool.friction.coefficient = 2e6;
    flow::FlowMatrix matrix(box.glass.mesh, box.problem.planes, box.problem.fixed);
    box.glass.velocity = Eigen::VectorXd::Zero(3 * box.glass.mesh.node_count());
    const auto step = flow::step_flow(box.problem, matrix, box.glass, 1e-4);
    ASSERT_TRUE(step.accepted);
    const double slides = box.glass.velocity[0], drag = 1e3 / 2e-3;
    const double exact = law == flow::Friction::Law::slip     ? 0
                         : law == flow::Friction::Law::navier ? 0.01 * 2e6 / (2e6 + drag)
                                                              : 0.01;
    fmt::print("law {} slides {:.9f} exact {:.9f}\n", int(law), slides, exact);
    if (law == flow::Friction::Law::stick)
      expect_at_most("slip of glass that sticks, over the speed of the tool", std::abs(slides / exact - 1), 0.02);
    else
      EXPECT_NEAR(slides, exact, 1e-8);
  }
}

TEST(SolidContact, GlassThatAToolGripsDoesNotCreepIntoIt) {
  Box box;
  box.hold(0);
  box.hold(1);
  box.problem.tools[0].friction.law = flow::Friction::Law::grip;
  flow::FlowMatrix matrix(box.glass.mesh, box.problem.planes, {});
  const double face = std::sqrt(2e-3 * 1.5e-3), lowest = box.glass.mesh.nodes.front()[2];
  for (int step = 0; step < 50; ++step) ASSERT_TRUE(flow::step_flow(box.problem, matrix, box.glass, 0.1).accepted);
  expect_at_most("depth of glass in a tool that grips after 5 s of blow, over the size of a face",
                 (lowest - box.glass.mesh.nodes.front()[2]) / face, 4e-3);
}

TEST(SolidContact, ARoundParisonFillsASquareMould) {
  const double round = 20e-3, wall = 6e-3, bottom = 15e-3, top = 100e-3;
  const auto material = uniform_glass(1);
  const SquareCavity cavity(35e-3, 8e-3);
  flow::SolidGlass glass = glass_of(round_parison(5, 8, 1, round, wall, bottom, top), material);
  const auto from_axis = [=](const Vector3& x) {
    return x[2] > bottom + round ? x.head<2>().norm() : (x - Vector3(0, 0, bottom + round)).norm();
  };
  flow::SolidProblem problem;
  problem.material = &material;
  problem.planes = {plane_of(glass.mesh, Vector3::Unit(0)),
                    plane_of(glass.mesh, Vector3::Unit(1)),
                    {Vector3::Unit(2), nodes_where(glass.mesh, [=](const Vector3& x) { return x[2] > top - 1e-7; })}};
  problem.pressures = {
      {faces_where(glass.mesh, [=](const Vector3& x) { return from_axis(x) < round - wall + 1e-6; }), 1.0}};
  problem.contact_faces = faces_where(glass.mesh, [=](const Vector3& x) { return from_axis(x) > round - 1e-6; });
  problem.tools = {{&cavity, Vector3::Zero(), Vector3::Zero(), {}}};
  flow::FlowMatrix matrix(glass.mesh, problem.planes, {});
  const double before = core::cell_volumes(glass.mesh).sum();
  int steps = 0, factors = 0, near = 0;
  double volume = 0, deepest = 0;
  const auto points = static_cast<int>(problem.contact_faces.size()) * flow::contact_points_per_face;
  for (; steps < 150 && near < 0.97 * points; ++steps) {
    flow::SolidStepLimits limits;
    limits.longest = steps ? 1 : 0.01;
    const auto step = flow::step_flow(problem, matrix, glass, flow::propose_step(problem, glass, limits));
    EXPECT_TRUE(step.accepted);
    factors += step.factors;
    volume = std::max(volume, step.volume_error);
    near = 0;
    for (const flow::SolidContact& point : glass.contact) {
      near += point.gap < 5e-5;
      deepest = std::max(deepest, -point.gap);
    }
  }
  fmt::print("steps {} factors {} near {} of {} deepest {:.1f} um\n", steps, factors, near, points, 1e6 * deepest);
  EXPECT_GE(near, 0.97 * points);
  expect_at_most("steps of a blow into a square mould, 97 % of the glass at it", steps, 100);
  expect_at_most("its factorisations a step", double(factors) / steps, 1.5);
  expect_at_most("volume of a cell meanwhile", volume, 1e-9);
  expect_at_most("all volume", std::abs(core::cell_volumes(glass.mesh).sum() / before - 1), 1e-9);
  expect_at_most("deepest glass in the mould", 1e6 * deepest, 300, "um");
}

}  // namespace
}  // namespace parison::tests
