// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "flow_case.hpp"

namespace parison::flow {
namespace {

using core::Geometry;

Equilibrium equilibrium_of(FlowProblem& flow, double dilatation_rate) {
  flow.problem.with_dilatation_mode = true;
  flow.problem.dilatation_rate = dilatation_rate;
  return Solver(flow.mesh).find_equilibrium(flow.bound(), {});
}

/// Largest difference relative to the largest entry of `b`.
double difference(const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
  return (a - b).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
}

TEST(Dilatation, glass_without_contact_dilates_alike_in_all_directions) {
  for (const auto geometry : {Geometry::planar, Geometry::axisymmetric}) {
    FlowProblem flow(tests::structured(3, 4, [](double s, double t) { return Point(0.01 * s, 0.02 * t); }), geometry,
                     100);
    flow.boundary("left").kind = flow.boundary("bottom").kind = BoundaryCondition::Kind::symmetry;
    const auto equilibrium = equilibrium_of(flow, 0);
    ASSERT_TRUE(equilibrium.converged) << equilibrium.reason;
    Eigen::VectorXd expected(equilibrium.dilatation_mode.size());
    for (Index n = 0; n < flow.mesh.node_count(); ++n)
      expected.segment<core::dim>(core::dim * n) = flow.mesh.nodes[n] / (geometry == Geometry::planar ? 2 : 3);
    EXPECT_LT(difference(equilibrium.dilatation_mode, expected), 1e-9);
  }
}

/// A disc pressed by a plate with 200 N against another, its rim free.
FlowProblem pressed_disc() {
  FlowProblem flow(tests::structured(12, 8, [](double s, double t) { return Point(0.02 * s, 0.01 * t); }),
                   Geometry::axisymmetric, 100);
  flow.boundary("left").kind = BoundaryCondition::Kind::symmetry;
  flow.problem.tools.resize(2);
  flow.problem.tools[1].force = -200;
  flow.problem.tools[1].speed_limit = 10;
  flow.touch("bottom", 0, Point(0, 1));
  flow.touch("top", 1, Point(0, -1));
  return flow;
}

TEST(Dilatation, a_prescribed_dilatation_adds_its_mode_to_the_velocities_and_nothing_to_the_stress) {
  constexpr double rate = 1e-2;
  FlowProblem flow = pressed_disc();
  const auto without = equilibrium_of(flow, 0), with = equilibrium_of(flow, rate);
  ASSERT_TRUE(without.converged && with.converged);
  EXPECT_EQ(without.active, with.active);
  const Index vertices = flow.mesh.vertex_count(), velocities = Index(without.response.unknowns.size()) - vertices;
  EXPECT_LT(difference(with.response.unknowns.tail(vertices), without.response.unknowns.tail(vertices)), 1e-9);
  EXPECT_LT(difference(with.response.forces.normal, without.response.forces.normal), 1e-9);
  const Eigen::VectorXd added = with.response.unknowns.head(velocities) - without.response.unknowns.head(velocities);
  EXPECT_LT(difference(added, rate * with.dilatation_mode), 1e-7);
  // The plate of given force yields to the glass, the other one does not move.
  EXPECT_NEAR(with.response.tool_velocity[1] - without.response.tool_velocity[1], rate * with.tool_dilatation_mode[1],
              1e-7 * rate * with.tool_dilatation_mode[1]);
  EXPECT_GT(with.tool_dilatation_mode[1], 0);
  EXPECT_EQ(with.tool_dilatation_mode[0], 0);
}

TEST(Dilatation, what_is_added_after_the_solve_equals_what_is_prescribed_before_it) {
  constexpr double rate = 1e-2;
  FlowProblem flow = pressed_disc();
  auto later = equilibrium_of(flow, 0);
  add_dilatation(rate, later);
  const auto before = evaluate(flow.bound(), equilibrium_of(flow, rate));
  const auto after = evaluate(flow.bound(), std::move(later));
  ASSERT_TRUE(before.converged && after.converged);
  EXPECT_LT(difference(after.velocity, before.velocity), 1e-9);
  EXPECT_LT(difference(after.pressure, before.pressure), 1e-9);
  EXPECT_NEAR(after.tool_velocity[1], before.tool_velocity[1], 1e-9 * std::abs(before.tool_velocity[1]));
  EXPECT_NEAR(after.tool_force[1], -200, 1e-6);
  EXPECT_NEAR(after.correction_power, before.correction_power, 1e-9 * std::abs(before.correction_power));
  EXPECT_GT(std::abs(after.correction_power), 0);
}

TEST(Dilatation, the_mode_is_found_only_when_asked_for) {
  FlowProblem flow = pressed_disc();
  const auto solution = flow.solve();
  ASSERT_TRUE(solution.converged);
  EXPECT_EQ(solution.dilatation_mode.size(), 0);
}

}  // namespace
}  // namespace parison::flow
