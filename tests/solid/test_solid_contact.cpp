// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "figure.hpp"
#include "solid/hex_block.hpp"

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

TEST(SolidContact, ABlownSquareTubeThinsTowardsItsCornerAsAMembraneThatSticks) {
  const double thin = getenv("TH") ? atof(getenv("TH")) : 0.025;
  SquareTube tube(getenv("NA") ? atoi(getenv("NA")) : 48, thin, flow::Friction::Law::stick);
  flow::FlowMatrix matrix(tube.glass.mesh, tube.problem.planes, {});
  const auto corner =
      nodes_where(tube.glass.mesh, [](const Vector3& x) { return std::abs(x[0] - x[1]) < 1e-9 && x[2] < 1e-9; });
  Index inside = corner[0], outside = corner[0];
  for (const Index n : corner) {
    if (tube.glass.mesh.nodes[n].norm() < tube.glass.mesh.nodes[inside].norm()) inside = n;
    if (tube.glass.mesh.nodes[n].norm() > tube.glass.mesh.nodes[outside].norm()) outside = n;
  }
  double time = 0, last = 0, rate = 0;
  int steps = 0, refused = 0, factors = 0, solutions = 0;
  const auto start = std::chrono::steady_clock::now();
  while (steps < 400) {
    flow::SolidStepLimits limits;
    limits.strain = getenv("ST") ? atof(getenv("ST")) : 0.05;
    limits.landing = getenv("LA") ? atof(getenv("LA")) : 2e-5;
    limits.longest = steps || refused ? 1 : 1e-3 * thin;
    const double dt = flow::propose_step(tube.problem, tube.glass, rate, last, limits);
    flow::SolidStep step = flow::step_flow(tube.problem, matrix, tube.glass, dt);
    if (!step.accepted) {
      fmt::print("refused at {} dt {:.3e} volume {:.1e} strain {}\n", steps, dt, step.volume_error, step.strain);
      last = 0.5 * dt / limits.growth;
      if (++refused > 20) break;
      continue;
    }
    time += dt;
    last = dt;
    rate = step.strain / dt;
    ++steps;
    factors += step.factors;
    solutions += step.solutions;
    const double far = tube.glass.mesh.nodes[outside].head<2>().norm();
    const double r = (std::sqrt(2) * radius - far) / (std::sqrt(2) - 1) / radius;
    const double h = (tube.glass.mesh.nodes[outside] - tube.glass.mesh.nodes[inside]).norm() / (thin * radius);
    if (steps % 10 == 0 || r < 0.3)
      fmt::print(
          "step {} dt {:.2e} r/R0 {:.4f} h/h0 {:.5f} membrane {:.5f} time {:.6f} touches {} doubt {} factors {} "
          "solutions {} force {:.4f} volume {:.1e}\n",
          steps, dt, r, h, std::pow(r, 4 / M_PI - 1), time / thin / 10,
          std::count_if(tube.glass.contact.begin(), tube.glass.contact.end(), [](const auto& c) { return c.touches; }),
          step.points_in_doubt, step.factors, step.solutions, step.tool_forces[0][0], step.volume_error);
    if (r < 0.3) break;
  }
  fmt::print("steps {} factors {} solutions {} seconds {}\n", steps, factors, solutions,
             std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace
}  // namespace parison::tests
