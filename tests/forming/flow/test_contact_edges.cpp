// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "flow_case.hpp"
#include "forming/flow/cells/element_matrix.hpp"
#include "forming/flow/surface.hpp"

namespace parison::flow {
namespace {

using core::Geometry;

/// Force that holds each node in place of the stresses, gravity, air and surface tension, N, two rows a node.
Eigen::VectorXd nodal_reactions(const FlowProblem& flow, const Solution& solution) {
  const auto geometry = cell_geometry(flow.mesh, flow.problem.geometry);
  const auto cells = cell_matrices(flow.problem, geometry, viscosity_field(flow.problem, geometry, solution.velocity));
  std::vector<bool> in_contact(flow.mesh.nodes.size(), false);
  for (std::size_t i = 0; i < solution.active.size(); ++i)
    if (solution.active[i]) in_contact[flow.problem.candidates[i].node] = true;
  Eigen::VectorXd reaction = -surface_load(flow.mesh, surface_edges(flow.problem), in_contact);
  for (Index c = 0; c < flow.mesh.cell_count(); ++c) {
    Eigen::Matrix<double, cell_unknowns, 1> x;
    for (int i = 0; i < 6; ++i) x.segment<2>(2 * i) = node_velocity(solution.velocity, flow.mesh.cells()[c][i]);
    for (int i = 0; i < 3; ++i) x[cell_velocities + i] = solution.pressure[flow.mesh.cells()[c][i]];
    const Eigen::Matrix<double, cell_unknowns, 1> force = cells.of(c) * x;
    for (int k = 0; k < cell_velocities; ++k)
      reaction[2 * flow.mesh.cells()[c][k / 2] + k % 2] += force[k] - cells.load_at(c, k);
  }
  return reaction;
}

/// Gap rate >= 0, force >= 0 and their product 0 at every candidate. Vertices bear the half of their neighbours' force.
void expect_complementary(const FlowProblem& flow, const Solution& solution) {
  const Eigen::VectorXd reaction = nodal_reactions(flow, solution);
  Eigen::VectorXd shared = reaction;
  for (const auto& edge : flow.mesh.boundary_edges())
    for (int end = 0; end < 2; ++end)
      shared.segment<2>(2 * edge.nodes[end]) += 0.5 * reaction.segment<2>(2 * edge.nodes[2]);
  const double fastest = solution.velocity.lpNorm<Eigen::Infinity>(), strongest = reaction.lpNorm<Eigen::Infinity>();
  for (std::size_t i = 0; i < flow.problem.candidates.size(); ++i) {
    const auto& candidate = flow.problem.candidates[i];
    const Point tool = solution.tool_velocity[candidate.tool] * core::axis_direction();
    const double opening =
        candidate.normal.dot(node_velocity(solution.velocity, candidate.node) - tool) - candidate.rate;
    const double own = candidate.normal.dot(node_velocity(reaction, candidate.node));
    const double borne = candidate.normal.dot(node_velocity(shared, candidate.node));
    const std::string where = "candidate " + std::to_string(i) + " at (" +
                              std::to_string(1e3 * flow.mesh.nodes[candidate.node][0]) + ", " +
                              std::to_string(1e3 * flow.mesh.nodes[candidate.node][1]) + ") mm";
    EXPECT_GE(opening, -1e-9 * fastest - 1e-8) << where;
    if (solution.active[i]) {
      EXPECT_LE(std::abs(opening), 1e-9 * fastest) << where;
      EXPECT_GE(std::max(own, borne), -1e-6 * strongest) << where;
    }
  }
}

FlowProblem block(Index n, Geometry geometry, double viscosity = 1e3) {
  return FlowProblem(tests::structured(n, n, [](double s, double t) { return Point(0.01 * s, 0.01 * t); }), geometry,
                     viscosity);
}

TEST(ContactEdges, two_tools_that_close_on_the_glass_press_alike) {
  FlowProblem flow = block(8, Geometry::axisymmetric);
  flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  flow.problem.tools.resize(2);
  flow.problem.tools[0].velocity = 0.02;
  flow.problem.tools[1].velocity = -0.01;
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("top", 1, Point(0, -1));
  const auto solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  expect_complementary(flow, solution);
  EXPECT_GT(solution.tool_force[0], 0);
  EXPECT_NEAR(solution.tool_force[0], -solution.tool_force[1], 1e-9 * solution.tool_force[0]);
}

/// Glass between two tools that forces drive against each other, 10 N from above.
Solution pressed_from_both_sides(double from_below) {
  FlowProblem flow = block(8, Geometry::axisymmetric);
  flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  flow.problem.tools.resize(2);
  flow.problem.tools[0].force = from_below;
  flow.problem.tools[1].force = -10;
  for (auto& tool : flow.problem.tools) tool.speed_limit = 1;
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("top", 1, Point(0, -1));
  auto solution = flow.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  if (solution.converged) expect_complementary(flow, solution);
  return solution;
}

TEST(ContactEdges, the_weaker_of_two_forces_against_each_other_gives_way_at_the_speed_limit) {
  const auto even = pressed_from_both_sides(10), uneven = pressed_from_both_sides(12);
  const double closing = even.tool_velocity[0] - even.tool_velocity[1];
  EXPECT_NEAR(even.tool_force[0], 10, 1e-6);
  EXPECT_NEAR(even.tool_velocity[0], -even.tool_velocity[1], 1e-2 * closing);
  EXPECT_NEAR(uneven.tool_velocity[0], 1, 1e-12);
  EXPECT_NEAR(uneven.tool_velocity[1], 1 - closing, 1e-6);
  EXPECT_NEAR(uneven.tool_force[1], -10, 1e-6);
  EXPECT_NEAR(uneven.tool_force[0], 10, 1e-6);
}

TEST(ContactEdges, a_node_in_the_corner_of_two_tools_is_held_by_both) {
  FlowProblem flow = block(6, Geometry::planar);
  constexpr double side = 0.01, speed = 0.01, air = 5e3, viscosity = 1e3;
  flow.problem.tools.resize(3);
  for (auto& tool : flow.problem.tools) tool.friction.law = Friction::Law::slip;
  flow.problem.tools[2].velocity = -speed;
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("left", 1, Point(1, 0));
  flow.touch("top", 2, Point(0, -1));
  flow.boundary("right").pressure = air;
  const auto solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  expect_complementary(flow, solution);
  for (std::size_t i = 0; i < solution.active.size(); ++i) EXPECT_TRUE(solution.active[i]);
  EXPECT_NEAR(solution.tool_force[0], (4 * viscosity * speed / side + air) * side,
              1e-7);  // plane strain: 4 eta rate + air
  EXPECT_NEAR(solution.tool_force[2], -solution.tool_force[0], 1e-7);
  const Eigen::VectorXd reaction = nodal_reactions(flow, solution);
  double wall = 0;
  for (const Index node : flow.nodes_of("left")) wall += node_velocity(reaction, node)[0];
  EXPECT_NEAR(wall, air * side, 1e-7);
}

TEST(ContactEdges, the_corner_of_a_punch_presses_into_a_smooth_surface) {
  for (const auto law : {Friction::Law::slip, Friction::Law::stick}) {
    FlowProblem flow = block(16, Geometry::planar);
    flow.boundary("bottom").kind = BoundaryCondition::Kind::fixed;
    flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
    flow.problem.tools.resize(1);
    flow.problem.tools[0].friction.law = law;
    flow.problem.tools[0].velocity = -0.01;
    constexpr double half_width = 0.0041;
    for (const Index node : flow.nodes_of("top"))
      if (flow.mesh.nodes[node][0] <= half_width) flow.problem.candidates.push_back({node, 0, Point(0, -1), 0.0});
    const auto solution = flow.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    expect_complementary(flow, solution);
    double rim = 0, middle = 0;
    for (const auto& candidate : flow.problem.candidates) {
      const double x = flow.mesh.nodes[candidate.node][0], pressure = solution.contact_pressure[candidate.node];
      EXPECT_NEAR(node_velocity(solution.velocity, candidate.node)[1], -0.01, 1e-12);
      if (x == 0) middle = pressure;
      if (x > half_width - 5e-4) rim = std::max(rim, pressure);
    }
    std::printf("punch: force %.2f N/m, pressure by its corner %.2f times that of its middle\n", solution.tool_force[0],
                rim / middle);
    EXPECT_GT(rim, 1.2 * middle);  // singular at the corner
  }
}

TEST(ContactEdges, surface_tension_lifts_the_rim_and_the_rest_bears_the_weight) {
  FlowProblem flow = block(12, Geometry::axisymmetric);
  flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  flow.material.density = 2400;
  flow.material.surface_tension = 0.3;
  flow.problem.gravity = -9.81;
  flow.problem.tools.resize(1);
  flow.problem.tools[0].friction.law = Friction::Law::slip;
  flow.touch("bottom", 0, Point(0, 1));
  long last = 0;
  for (const double tension : {0.0, 0.3, 3.0}) {
    flow.material.surface_tension = tension;
    const auto solution = flow.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    expect_complementary(flow, solution);
    const double weight = 2400 * 9.81 * M_PI * 1e-6;
    EXPECT_NEAR(solution.tool_force[0], weight, 1e-7 * weight);
    const auto closed = std::count(solution.active.begin(), solution.active.end(), true);
    std::printf("tension %.1f N/m: %ld of %zu nodes stay, %d solves\n", tension, long(closed), solution.active.size(),
                solution.iterations);
    if (tension > 0) EXPECT_LT(closed, last);
    last = closed;
  }
}

/// A cylinder that fills a pot closed by a plunger.
FlowProblem full_pot(Friction::Law law) {
  FlowProblem flow = block(8, Geometry::axisymmetric);
  flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  flow.problem.tools.resize(2);
  for (auto& tool : flow.problem.tools) tool.friction.law = law;
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("right", 0, Point(-1, 0));
  flow.touch("top", 1, Point(0, -1));
  return flow;
}

TEST(ContactEdges, a_full_cavity_stays_regular_and_its_force_follows_the_plunger) {
  for (const auto law : {Friction::Law::slip, Friction::Law::stick}) {
    FlowProblem flow = full_pot(law);
    flow.problem.tools[1].velocity = -1e-6;
    auto solution = flow.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    expect_complementary(flow, solution);
    EXPECT_LT(solution.tool_force[1], -1e5);  // a micrometre a second: what does not yield pushes back
    for (const double force : {-1e2, -1e4, -1e6}) {
      flow.problem.tools[1].force = force;
      flow.problem.tools[1].speed_limit = 0.1;
      solution = flow.solve();
      ASSERT_TRUE(solution.converged) << solution.reason;
      expect_complementary(flow, solution);
      const double pressure = -force / (M_PI * 1e-4);
      EXPECT_NEAR(solution.tool_force[1], force, -1e-9 * force);
      EXPECT_LT(std::abs(solution.tool_velocity[1]), 1e-4);
      for (Index n = 0; n < flow.mesh.vertex_count(); ++n) EXPECT_NEAR(solution.pressure[n], pressure, 1e-5 * pressure);
    }
  }
}

TEST(ContactEdges, a_full_cavity_leaks_through_its_vent_alone) {
  FlowProblem flow = block(16, Geometry::axisymmetric);
  flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  flow.problem.tools.resize(2);
  flow.problem.tools[1].velocity = -0.01;
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("top", 1, Point(0, -1));
  for (const Index node : flow.nodes_of("right"))
    if (flow.mesh.nodes[node][1] < 0.0089) flow.problem.candidates.push_back({node, 0, Point(-1, 0), 0.0});
  const auto solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  expect_complementary(flow, solution);
  double out = 0;
  for (const auto& edge : flow.mesh.boundary_edges())
    if (flow.mesh.boundaries()[edge.boundary_id].name == "right")
      for (const auto& rule : core::edge_rule(3)) {
        const auto at = core::map_edge_point(flow.mesh, edge.nodes, Geometry::axisymmetric, rule);
        for (int i = 0; i < 3; ++i) out += at.area * at.shape[i] * node_velocity(solution.velocity, edge.nodes[i])[0];
      }
  EXPECT_NEAR(out, 0.01 * M_PI * 1e-4, 1e-7 * out);
  EXPECT_LT(solution.tool_force[1], 0);
}

}  // namespace
}  // namespace parison::flow
