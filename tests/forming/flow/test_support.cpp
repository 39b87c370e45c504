// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "flow_case.hpp"
#include "forming/flow/contact/constraints.hpp"

namespace parison::flow {
namespace {

using core::Geometry;

FlowProblem block(Geometry geometry) {
  FlowProblem flow(tests::structured(6, 6, [](double s, double t) { return Point(0.01 * (1 + s), 0.01 * t); }),
                   geometry, 1e3);
  flow.material.density = 2400;
  flow.problem.gravity = -9.81;
  flow.problem.tools.resize(1);
  flow.problem.tools[0].friction.law = Friction::Law::slip;
  return flow;
}

void expect_named(FlowProblem& flow, const std::string& motion) {
  const std::string sentence = "the glass is not constrained: it is free to " + motion +
                               ", which no tool, symmetry plane or fixed boundary prevents";
  EXPECT_EQ(free_motion(flow.bound()), sentence);
  const auto solution = flow.solve();
  EXPECT_FALSE(solution.converged);
  EXPECT_EQ(solution.reason, sentence);
}

void expect_solved(FlowProblem& flow) {
  EXPECT_EQ(free_motion(flow.bound()), "");
  const auto solution = flow.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
}

TEST(Support, a_ring_in_the_air_falls) {
  auto flow = block(Geometry::axisymmetric);
  expect_named(flow, "move along the axis");
  flow.touch("bottom", 0, Point(0, 1));
  expect_solved(flow);
}

TEST(Support, a_plane_block_on_a_slipping_plate_glides) {
  auto flow = block(Geometry::planar);
  flow.touch("bottom", 0, Point(0, 1));
  expect_named(flow, "move sideways");
  flow.problem.tools[0].friction.law = Friction::Law::stick;
  expect_solved(flow);
}

/// A stiff block on a plate whose friction changes along it with the temperature of the glass, drawn by a force f in
/// its volume: v = f H L/int beta dx, with beta exponential between two temperatures; H, L: height and length.
double gliding_error(int cells) {
  constexpr double length = 0.01, height = 0.01, force = 1e4, low = 1e3, high = 1e5;
  FlowProblem flow(tests::structured(cells, 4, [=](double s, double t) { return Point(length * s, height * t); }),
                   Geometry::planar, 1e9);
  for (Index n = 0; n < flow.mesh.node_count(); ++n) flow.temperature[n] = 1000 + 100 * flow.mesh.nodes[n][0] / length;
  flow.problem.force = [=](const Point&) { return Point(force, 0); };
  flow.problem.tools.resize(1);
  flow.problem.tools[0].friction = {
      Friction::Law::navier, 0, {}, core::Table{{1000, 1100}, {std::log(high), std::log(low)}}};
  for (const Index node : flow.nodes_of("bottom")) flow.problem.candidates.push_back({node, 0, Point(0, 1), 0.0, true});
  const auto solution = flow.solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  const double exact = force * height * std::log(high / low) / (high - low);
  double error = 0;
  for (Index n = 0; n < flow.mesh.node_count(); ++n)
    error = std::max(error, std::abs(node_velocity(solution.velocity, n)[0] / exact - 1));
  return error;
}

TEST(Support, a_block_glides_as_friction_by_temperature_lets_it_in_the_order_of_simpsons_rule) {
  const double coarse = gliding_error(4), fine = gliding_error(8);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.3);
  EXPECT_LT(gliding_error(16), 1e-5);
}

TEST(Support, friction_by_temperature_goes_through_its_points_and_is_constant_beyond) {
  const Friction friction{
      Friction::Law::navier, 0, {}, core::Table{{900, 1000, 1300}, {std::log(1e7), std::log(1e6), 0}}};
  EXPECT_NEAR(friction.coefficient_at(1000), 1e6, 1e-3);
  EXPECT_NEAR(friction.coefficient_at(950), std::sqrt(1e13), 1e-2);
  EXPECT_NEAR(friction.coefficient_at(300), 1e7, 1e-2);
  EXPECT_NEAR(friction.coefficient_at(2000), 1, 1e-9);
  const Friction one{Friction::Law::navier, 5e4, {}};
  EXPECT_EQ(one.coefficient_at(1000), 5e4);
}

TEST(Support, a_plane_body_hung_on_one_node_turns) {
  auto flow = block(Geometry::planar);
  flow.problem.tools[0].friction.law = Friction::Law::grip;
  flow.problem.candidates.push_back({*flow.nodes_of("top").begin(), 0, Point(0, -1), 0.0, true});
  expect_named(flow, "turn");
}

TEST(Support, a_half_ring_in_a_slipping_round_mould_turns) {
  const auto ring = [](double s, double t) {
    return Point(0.01 * (1 + s) * std::cos(M_PI * t), 0.01 * (1 + s) * std::sin(M_PI * t));
  };
  FlowProblem flow(tests::structured(3, 24, ring), Geometry::planar, 1e3);
  flow.problem.tools.resize(1);
  flow.problem.tools[0].friction.law = Friction::Law::slip;
  for (const Index node : flow.nodes_of("right"))
    flow.problem.candidates.push_back({node, 0, -flow.mesh.nodes[node].normalized(), 0.0});
  expect_named(flow, "turn");
  flow.boundary("bottom").kind = BoundaryCondition::Kind::symmetry;
  expect_solved(flow);
}

/// Tools all around: the pressure takes its lowest level at which nothing pulls.
TEST(Support, glass_shut_in_by_tools_presses_with_its_weight_alone) {
  auto flow = block(Geometry::axisymmetric);
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("right", 0, Point(-1, 0));
  flow.touch("left", 0, Point(1, 0));
  flow.touch("top", 0, Point(0, -1));
  const auto solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  const double weight = 2400 * 9.81 * M_PI * 3e-6;
  EXPECT_NEAR(solution.tool_force[0], weight, 1e-7 * weight);
  for (Index n = 0; n < flow.mesh.vertex_count(); ++n)
    EXPECT_NEAR(solution.pressure[n], 2400 * 9.81 * (0.01 - flow.mesh.nodes[n][1]), 1e-3);
}

}  // namespace
}  // namespace parison::flow

namespace parison::forming {
namespace {

TEST(Support, a_stage_in_which_nothing_constrains_the_glass_is_refused) {
  const std::string stage = "name = \"rest\"\nduration = \"1 s\"\ntools = [\"plate\"]";
  const auto text = replaced(stage, "name = \"rest\"\nduration = \"1 s\"\ngravity = \"-9.81 m/s2\"");
  EXPECT_EQ(
      complaint_about(text),
      std::to_string(line_of("[[stage]]", text)) +
          ": stage.tools: nothing constrains the glass along the axis in stage \"rest\"; allowed is a tool "
          "that it can touch, a fixed boundary, a symmetry plane across the axis, or neither gravity nor pressure");
}

TEST(Support, glass_enclosed_by_fixed_boundaries_is_refused) {
  const auto unpressed = replaced("pressure.surface = \"0.1 bar\"\n", "");
  const auto text = replaced("condition = \"contact\" },\n  { name = \"axis\", path = \"(0, 0) mm\"",
                             "condition = \"fixed\" },\n  { name = \"axis\", path = \"(0, 0) mm\"", unpressed);
  EXPECT_EQ(complaint_about(text),
            std::to_string(line_of("boundary = [", text)) +
                ": glass.boundary: every boundary is fixed or a symmetry plane, so the pressure of the glass has no "
                "reference value; allowed is at least one boundary that is neither");
}

}  // namespace
}  // namespace parison::forming
