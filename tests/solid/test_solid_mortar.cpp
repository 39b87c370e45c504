// SPDX-License-Identifier: GPL-3.0-or-later
// Bodies in space that touch, against exact solutions.
#include <gtest/gtest.h>

#include "contact/solid/solid_mortar.hpp"
#include "core/math/numbers.hpp"
#include "figure.hpp"
#include "solid/solid_meshes.hpp"

namespace parison::thermal::test {
namespace {

constexpr double side = 0.01, h_contact = 2000, hot = 1273.15, cold = 673.15;
constexpr double exact_flux = 70375.9398496241, exact_jump = 35.1879699248120;

/// Turns points near the middle of a square about its axis; the outline stays.
Vector3 twisted(const Vector3& x, double angle) {
  const double u = x[0] / side - 0.5, v = x[1] / side - 0.5;
  const double turn = angle * (1 - 4 * u * u) * (1 - 4 * v * v);
  return {side * (0.5 + u * std::cos(turn) - v * std::sin(turn)),
          side * (0.5 + u * std::sin(turn) + v * std::cos(turn)), x[2]};
}

struct Pile {
  Material glass_material{2500, core::constant(1300), core::constant(1.3), {}};
  Material tool_material{7800, core::constant(500), core::constant(30), {}};
  Block glass;
  core::PrismMesh tool;
  Eigen::VectorXd glass_mass, tool_mass;
  SolidProblem problem;

  Pile(int n_glass, int n_tool, double twist, int degree = 4) {
    glass = block(n_glass, n_glass, 2, [&](const Vector3& x) { return twisted(side * x, twist); });
    straighten(glass.mesh);
    const auto along = divide(side, 2 * side, n_tool), down = divide(-side, 0, 2);
    tool = core::sweep(rectangle(along, down), 0, side, n_tool, [&](double r, double z, double angle) {
      return twisted({r - side, angle, z}, -twist);
    });
    straighten(tool);
    glass_mass = masses(glass.mesh, core::hexahedron_table(), glass_material);
    tool_mass = masses(tool, core::prism_table(), tool_material);
    problem.bodies = {solid_body(glass.mesh, glass.faces, glass_mass, glass_material),
                      solid_body(tool, tool_mass, tool_material)};
    const auto slave = contact::solid_surface(0, glass.mesh.nodes, glass.faces, {z_low});
    const auto master = contact::solid_surface(1, tool.nodes, tool.faces, {top});
    problem.interface = contact::build_interface(slave, {{master, 0, 1e-4}}, {2e-3, degree});
    problem.law = constant_solid_conductance(h_contact);
  }
};

double area_of(const core::SolidInterface& interface) {
  double sum = 0;
  for (const auto& point : interface.points) sum += point.contact_weight * point.area;
  return sum;
}

/// Prescribes the ends of a pile and lets it settle; adds how far flux and faces are off.
void settle_pile(Pile& pile, tests::Figure& flux, tests::Figure& jump) {
  auto& bodies = pile.problem.bodies;
  bodies[0].prescribed.resize(6);
  bodies[0].prescribed[z_high] = core::TimeFunction(hot);
  bodies[1].prescribed.resize(4);
  bodies[1].prescribed[bottom] = core::TimeFunction(cold);
  const StepOutcome end = settle(pile.problem, {Eigen::VectorXd::Constant(pile.glass.mesh.node_count(), hot),
                                                Eigen::VectorXd::Constant(pile.tool.node_count(), cold)});
  ASSERT_TRUE(end.converged) << end.reason;
  flux.add(std::abs(end.balance.pairs[0].heat / 1e9 / (side * side) / exact_flux - 1));
  const auto check = [&](const auto& faces, Index boundary, const Eigen::VectorXd& temperature, double exact) {
    for (const core::QuadFace& face : faces)
      for (const Index node : face.nodes)
        if (face.boundary_id == boundary) jump.add(std::abs(temperature[node] - exact) / exact_jump);
  };
  check(pile.glass.faces, z_low, end.temperature[0], hot - exact_flux * side / 1.3);
  check(pile.tool.faces, top, end.temperature[1], cold + exact_flux * side / 30);
}

TEST(SolidMortar, boxes_of_other_cells_pass_the_exact_heat_whichever_is_coarser) {
  tests::Figure flux("heat through boxes of other cells: off by"),
      jump("temperatures of their faces over the jump: off by");
  for (const auto& [n_glass, n_tool] : {std::pair{4, 3}, {2, 5}, {5, 2}, {1, 4}}) {
    Pile pile(n_glass, n_tool, 0);
    settle_pile(pile, flux, jump);
  }
  flux.at_most(1e-9);
  jump.at_most(1e-9);
}

TEST(SolidMortar, boxes_twisted_against_each_other_pass_the_exact_heat) {
  tests::Figure flux("heat through boxes twisted against each other: off by"),
      jump("temperatures of twisted faces over the jump: off by");
  for (const auto& [n_glass, n_tool] : {std::pair{4, 3}, {2, 5}, {5, 2}}) {
    Pile pile(n_glass, n_tool, 0.3, 6);
    EXPECT_NEAR(area_of(pile.problem.interface), side * side, 1e-12 * side * side);
    settle_pile(pile, flux, jump);
  }
  flux.at_most(1e-9);
  jump.at_most(1e-4);
}

TEST(SolidMortar, a_hidden_master_gets_nothing) {
  Pile pile(3, 2, 0.2);
  core::PrismMesh behind = pile.tool;
  for (Vector3& x : behind.nodes) x[2] -= 1e-4;
  const auto slave = contact::solid_surface(0, pile.glass.mesh.nodes, pile.glass.faces, {z_low});
  const auto master = [&](Index body, const core::PrismMesh& mesh) {
    return contact::SolidMaster{contact::solid_surface(body, mesh.nodes, mesh.faces, {top}), 0, 1e-3};
  };
  const auto interface = contact::build_interface(slave, {master(2, behind), master(1, pile.tool)});
  EXPECT_NEAR(area_of(interface), side * side, 1e-12 * side * side);
  for (const auto& point : interface.points) EXPECT_EQ(interface.pairs[point.pair].master_body, 1);
}

TEST(SolidMortar, pressure_and_gap_are_those_of_the_flow_and_weigh_the_contact) {
  Pile pile(3, 2, 0.2);
  const auto slave = contact::solid_surface(0, pile.glass.mesh.nodes, pile.glass.faces, {z_low});
  const auto nodes = pile.glass.mesh.nodes;
  const auto state = [&](Index face, const std::array<double, 2>& place) {
    const double x = core::face_place(nodes, pile.glass.faces[face], place[0], place[1]).position[0];
    return contact::ContactState{x < side / 3 ? 0 : core::infinity, 1e5 * x};
  };
  const auto interface = contact::build_interface(
      slave, {{contact::solid_surface(1, pile.tool.nodes, pile.tool.faces, {top}), 3, 1e-4, state}});
  ASSERT_FALSE(interface.points.empty());
  for (const auto& point : interface.points) {
    EXPECT_LT(point.position[0], side / 3);
    EXPECT_NEAR(point.pressure, 1e5 * point.position[0], 1e-9);
    EXPECT_EQ(point.law, 3);
  }
  EXPECT_NEAR(area_of(interface), side * side / 3, 0.1 * side * side);
  EXPECT_GT(interface.pairs.size(), 12u);  // those that are only near as well
}

TEST(SolidMortar, a_contact_that_opens_within_cells_has_its_exact_area) {
  const Pile pile(3, 2, 0.2);
  const auto slave = contact::solid_surface(0, pile.glass.mesh.nodes, pile.glass.faces, {z_low});
  tests::Figure off("area of a contact that opens within cells, in space: off by, share of the face");
  constexpr double width = 1e-4, slope = 0.1;  // open over 1 mm, a third of a cell
  for (const double end : {0.2, 0.37, 0.44, 0.5, 0.61, 0.75}) {
    const auto state = [&](Index face, const std::array<double, 2>& place) {
      const Vector3 x = core::face_place(pile.glass.mesh.nodes, pile.glass.faces[face], place[0], place[1]).position;
      return contact::ContactState{slope * (x[0] - end * side), 0};
    };
    const auto interface = contact::build_interface(
        slave, {{contact::solid_surface(1, pile.tool.nodes, pile.tool.faces, {top}), 0, width, state}});
    // The weight's mean over the opening is a half.
    off.add(std::abs(area_of(interface) / (side * side) - (end + 0.5 * width / slope / side)));
  }
  off.at_most(5e-3);
}

TEST(SolidMortar, a_tool_with_an_axis_is_met_everywhere) {
  const Block glass = block(3, 3, 1, [](const Vector3& x) -> Vector3 { return side * x; });
  const auto tool = core::sweep(rectangle(divide(0, 2 * side, 3), divide(-side, 0, 1)), 0, M_PI / 2, 4);
  const auto interface =
      contact::build_interface(contact::solid_surface(0, glass.mesh.nodes, glass.faces, {z_low}),
                               {{contact::solid_surface(1, tool.nodes, tool.faces, {top}), 0, 1e-4}});
  EXPECT_NEAR(area_of(interface), side * side, 1e-12);
  for (const auto& point : interface.points) {
    const core::FacePair& pair = interface.pairs[point.pair];
    Vector3 there = Vector3::Zero();
    for (int i = 0; i < 9; ++i) there += point.master_shape[i] * tool.nodes[tool.faces[pair.master_face].nodes[i]];
    EXPECT_LT((there - point.position).norm(), 1e-12);
  }
}

/// Heat per metre, W/m, and mean jump, K, of a wedge of glass in a wedge of mould.
std::array<double, 2> cylinder_errors(int n) {
  const Material glass_material{2500, core::constant(1300), core::constant(1.3), {}};
  const Material tool_material{7800, core::constant(500), core::constant(30), {}};
  constexpr double wedge = 0.7, height = 0.01;
  const Block glass = block(n, n, n, [](const Vector3& x) -> Vector3 {
    return core::round_section(0.02 + 0.01 * x[2], height * x[1], wedge * x[0]);
  });
  const auto tool = core::sweep(rectangle(divide(0.03, 0.05, n), divide(0, height, n + 1)), 0, wedge, n + 1);
  const auto glass_mass = masses(glass.mesh, core::hexahedron_table(), glass_material);
  const auto tool_mass = masses(tool, core::prism_table(), tool_material);
  SolidProblem problem{
      {solid_body(glass.mesh, glass.faces, glass_mass, glass_material), solid_body(tool, tool_mass, tool_material)},
      {},
      constant_solid_conductance(h_contact)};
  problem.bodies[0].prescribed.resize(6);
  problem.bodies[0].prescribed[z_low] = core::TimeFunction(hot);
  problem.bodies[1].prescribed.resize(4);
  problem.bodies[1].prescribed[right] = core::TimeFunction(cold);
  problem.interface = contact::build_interface(contact::solid_surface(0, glass.mesh.nodes, glass.faces, {z_high}),
                                               {{contact::solid_surface(1, tool.nodes, tool.faces, {left}), 0, 1e-3}});
  const StepOutcome end = settle(problem, {Eigen::VectorXd::Constant(glass.mesh.node_count(), hot),
                                           Eigen::VectorXd::Constant(tool.node_count(), cold)});
  EXPECT_TRUE(end.converged) << end.reason;
  const double heat = end.balance.pairs[0].heat / 1e9 / height * 2 * M_PI / wedge;
  double jump = 0, area = 0;
  for (const auto& point : problem.interface.points) {
    const core::FacePair& pair = problem.interface.pairs[point.pair];
    for (int i = 0; i < 9; ++i)
      jump += point.area * (point.slave_shape[i] * end.temperature[0][glass.faces[pair.slave_face].nodes[i]] -
                            point.master_shape[i] * end.temperature[1][tool.faces[pair.master_face].nodes[i]]);
    area += point.area;
  }
  return {std::abs(heat / 10908.61007 - 1), std::abs(jump / area / 28.93598691 - 1)};
}

TEST(SolidMortar, a_cylinder_in_a_mould_passes_the_exact_heat) {
  const auto coarse = cylinder_errors(2), fine = cylinder_errors(4);
  tests::expect_at_most("heat of a cylinder section in its mould: off by", fine[0], 2e-5);
  tests::expect_at_most("jump there: off by", fine[1], 2e-5);
  tests::expect_at_least("order of that heat", std::log2(coarse[0] / fine[0]), 2.5);
}

}  // namespace
}  // namespace parison::thermal::test
