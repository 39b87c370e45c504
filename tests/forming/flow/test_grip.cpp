// SPDX-License-Identifier: GPL-3.0-or-later
// A ring that grips: it holds the glass by its form, and glass that shrinks comes off it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "figure.hpp"
#include "flow_case.hpp"
#include "forming/flow/contact/grip.hpp"

namespace parison::flow {
namespace {

constexpr double inner = 28e-3, outer = 31e-3, height = 14e-3;

/// A finish in a ring, tool 0, that grips its outside.
FlowProblem finish(double viscosity) {
  const auto shape = [](double s, double t) { return Point(inner + (outer - inner) * s, height * t); };
  FlowProblem flow(tests::structured(4, 12, shape), core::Geometry::axisymmetric, viscosity);
  flow.material.density = 2400;
  flow.problem.tools.resize(1);
  flow.problem.tools[0].friction.law = Friction::Law::grip;
  flow.touch("right", 0, Point(-1, 0));
  for (auto& candidate : flow.problem.candidates) candidate.tied = true;
  return flow;
}

TEST(Grip, cold_glass_that_shrinks_comes_off_without_stress) {
  constexpr double rate = -3e-3, viscosity = 1e12;
  FlowProblem flow = finish(viscosity);
  flow.problem.expansion_rate.assign(flow.mesh.cell_count() * cell_points, rate);
  const Solution solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  EXPECT_EQ(std::count(solution.active.begin(), solution.active.end(), true), 0);
  double worst = 0;
  for (Index n = 0; n < flow.mesh.node_count(); ++n) {
    const Point& x = flow.mesh.nodes[n];
    const Point free(rate / 3 * x[0], rate / 3 * (x[1] - height / 2));
    worst = std::max(worst, (node_velocity(solution.velocity, n) - free).norm());
  }
  tests::Figure figure("finish that shrinks in a ring that grips: velocity off by, of the largest");
  figure.add(worst / std::abs(rate / 3 * outer));
  figure.at_most(1e-3);
  const double heat = std::accumulate(solution.dissipation.begin(), solution.dissipation.end(), 0.0);
  const double hindered = viscosity * rate * rate * M_PI * (outer * outer - inner * inner) * height;
  EXPECT_LT(std::abs(heat), 1e-6 * hindered);
}

TEST(Grip, a_finish_that_hangs_creeps_by_its_weight_over_the_drag) {
  FlowProblem flow = finish(1e10);
  flow.problem.gravity = -9.81;
  const Solution solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  const double weight = 2400 * 9.81 * M_PI * (outer * outer - inner * inner) * height;
  EXPECT_NEAR(solution.tool_force[0], weight, 1e-9 * weight);
  const double speed = weight / (grip_drag * 2 * M_PI * outer * height);
  const double creep = -integral(flow.mesh, core::Geometry::axisymmetric, solution.velocity)[1] /
                       core::volume(flow.mesh, core::Geometry::axisymmetric);
  EXPECT_NEAR(creep, speed, 1e-3 * speed);
}

TEST(Grip, glass_that_is_pressed_on_the_ring_slides_by_its_shear_over_the_drag) {
  constexpr double viscosity = 1e4;
  FlowProblem flow = finish(viscosity);
  flow.problem.gravity = -9.81;
  flow.boundary("left").pressure = 1e5;
  const Solution solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  double slip = 0, largest = 0;
  for (const Index n : flow.nodes_of("right")) slip = std::max(slip, node_velocity(solution.velocity, n).norm());
  for (Index n = 0; n < flow.mesh.node_count(); ++n)
    largest = std::max(largest, node_velocity(solution.velocity, n).norm());
  EXPECT_GT(largest, 1e-4) << "the glass flows towards its free ends";
  // Shear is at most some viscosity times the largest velocity over the cells beside the ring.
  EXPECT_LT(slip, viscosity * largest / ((outer - inner) / 4) / grip_drag * 10);
  EXPECT_GT(slip, 0);
}

/// A corner of a finish between a ring, tool 0, and a plate, tool 1, that both grip.
FlowProblem corner(double viscosity) {
  const auto shape = [](double s, double t) { return Point(inner + (outer - inner) * s, height * t); };
  FlowProblem flow(tests::structured(8, 24, shape), core::Geometry::axisymmetric, viscosity);
  flow.problem.tools.resize(2);
  for (auto& tool : flow.problem.tools) tool.friction.law = Friction::Law::grip;
  flow.touch("right", 0, Point(-1, 0));
  flow.touch("bottom", 1, Point(0, 1));
  for (auto& candidate : flow.problem.candidates) candidate.tied = true;
  return flow;
}

TEST(Grip, cold_glass_that_shrinks_in_a_corner_comes_off_both_tools) {
  constexpr double rate = -1e-2;
  FlowProblem flow = corner(1e12);
  flow.problem.expansion_rate.assign(flow.mesh.cell_count() * cell_points, rate);
  const Solution solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  EXPECT_EQ(std::count(solution.active.begin(), solution.active.end(), true), 0);
  // It shrinks towards the axis, and towards the height at which the drags on both tools are in balance.
  const double ring = 2 * outer * height, plate = outer * outer - inner * inner;
  const double still = height / 2 * ring / (ring + plate);
  double worst = 0;
  for (Index n = 0; n < flow.mesh.node_count(); ++n) {
    const Point& x = flow.mesh.nodes[n];
    worst = std::max(worst, (node_velocity(solution.velocity, n) - rate / 3 * Point(x[0], x[1] - still)).norm());
  }
  tests::Figure figure("cold glass that shrinks in a corner of two tools that grip: velocity off by, of the largest");
  figure.add(worst / std::abs(rate / 3 * outer));
  figure.at_most(1e-3);
}

TEST(Grip, cold_glass_in_a_corner_has_one_state_whatever_touched_before) {
  // Parts that shrink and grow beside each other, as a skin does that touches by turns.
  FlowProblem flow = corner(1e9);
  for (Index c = 0; c < flow.mesh.cell_count(); ++c)
    for (const auto& rule : core::triangle_rule(4)) {
      const Point x = core::map_cell_point(flow.mesh, c, core::Geometry::axisymmetric, rule).position;
      const double depth = std::min(outer - x[0], x[1]);
      flow.problem.expansion_rate.push_back(0.5 * std::cos(4e3 * (x[1] - x[0])) * std::exp(-depth / 5e-4));
    }
  const std::size_t count = flow.problem.candidates.size();
  const Solution closed = flow.solve(std::vector<bool>(count, true)),
                 open = flow.solve(std::vector<bool>(count, false));
  ASSERT_TRUE(closed.converged && open.converged);
  EXPECT_EQ(closed.locked + open.locked, 0);
  EXPECT_GT(std::count(open.active.begin(), open.active.end(), true), 3);
  EXPECT_LT(std::count(open.active.begin(), open.active.end(), true), std::ptrdiff_t(count) - 3);
  const double largest = closed.velocity.lpNorm<Eigen::Infinity>();
  EXPECT_LT((closed.velocity - open.velocity).lpNorm<Eigen::Infinity>(), 1e-6 * largest);
  for (int tool = 0; tool < 2; ++tool)
    EXPECT_NEAR(closed.tool_force[tool], open.tool_force[tool], 1e-5 * std::abs(closed.tool_force[tool]) + 1e-6);
  // Nothing but the drag holds it along the ring.
  EXPECT_LT(std::abs(closed.tool_force[0]), grip_drag * largest * 2 * M_PI * outer * height);
}

TEST(Grip, moves_the_glass_with_its_tool_and_what_slips_is_friction) {
  FlowProblem flow = finish(1e8);
  flow.problem.tools[0].velocity = 1e-3;
  flow.problem.gravity = -9.81;
  const Solution solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  const double weight = 2400 * 9.81 * M_PI * (outer * outer - inner * inner) * height;
  const double lifted =
      2400 * 9.81 * integral(flow.mesh, core::Geometry::axisymmetric, solution.velocity).dot(core::axis_direction());
  const double heat = std::accumulate(solution.dissipation.begin(), solution.dissipation.end(), 0.0);
  EXPECT_NEAR(solution.tool_force[0], weight, 1e-9 * weight);
  EXPECT_NEAR((weight * 1e-3 - lifted) / (heat + solution.friction_power), 1, 1e-6);
  EXPECT_GT(solution.friction_power, 0);
}

}  // namespace
}  // namespace parison::flow
