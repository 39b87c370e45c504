// SPDX-License-Identifier: GPL-3.0-or-later
// A cone that moves through a plate pushes the glass on the plate outwards: the corner of both.
#include <gtest/gtest.h>

#include <cmath>

#include "flow_case.hpp"
#include "forming/flow/contact/wedged_corner.hpp"

namespace parison::flow {
namespace {

constexpr double inner = 0.01, outer = 0.02, height = 0.01, slope = 0.1, speed = 1e-3, viscosity = 1e6;

/// A ring of glass on a plate, tool 0, around a cone, tool 1, that gets narrower upwards and moves up; `n` divisions
/// from side to side, narrower towards the corner, and a skin on both tools that is `stiffer` than the rest.
FlowProblem ring_around_cone(Index n, Friction::Law plate, double stiffer = 1) {
  const auto shape = [](double s, double t) {
    const double z = height * t * t, inside = inner - slope * z;
    return Point(inside + (outer - inside) * s * s, z);
  };
  FlowProblem flow(tests::structured(n, n, shape), core::Geometry::axisymmetric, viscosity);
  flow.problem.viscosity = [=](const Point& x) {
    const double depth = std::min(x[1], x[0] - inner + slope * x[1]);
    return viscosity * std::pow(stiffer, std::max(0.0, 1 - depth / 1e-3));
  };
  flow.problem.tools.resize(2);
  flow.problem.tools[0].friction.law = plate;
  flow.problem.tools[1].friction.law = Friction::Law::slip;
  flow.problem.tools[1].velocity = speed;
  flow.touch("bottom", 0, Point(0, 1));
  for (auto& candidate : flow.problem.candidates) candidate.tied = true;  // the cone would lift the ring
  flow.touch("left", 1, Point(1, slope).normalized());
  return flow;
}

double force_on_cone(Index n, Friction::Law plate, double stiffer = 1) {
  const auto solution = ring_around_cone(n, plate, stiffer).solve();
  EXPECT_TRUE(solution.converged) << solution.reason;
  return solution.tool_force[1];
}

TEST(WedgedCorner, without_friction_the_force_is_that_of_a_thick_ring_that_widens) {
  // A ring with free ends, widened at its inner radius a with u = V slope: v_r = C/r + C r/(3 b^2), p = 2 eta C (1/a^2
  // - 1/b^2), its inner radius and its height in the mean.
  const double a = inner - 0.5 * slope * height, b = outer;
  const double C = speed * slope * a / (1 + a * a / (3 * b * b));
  const double pressure = 2 * viscosity * C * (1 / (a * a) - 1 / (b * b));
  const double exact = pressure * 2 * M_PI * a * height * slope, found = force_on_cone(16, Friction::Law::slip);
  std::printf("force %.4f N, of a thick ring %.4f N\n", found, exact);
  EXPECT_NEAR(found / exact, 1, 0.03);
}

TEST(WedgedCorner, a_gripping_plate_gives_way_beside_it_and_the_force_does_not_grow_with_the_mesh) {
  for (const Friction::Law law : {Friction::Law::grip, Friction::Law::stick})
    for (const double stiffer : {1.0, 1e3}) {
      const double free = force_on_cone(32, Friction::Law::slip, stiffer);
      const double coarse = force_on_cone(8, law, stiffer), middle = force_on_cone(16, law, stiffer),
                   fine = force_on_cone(32, law, stiffer);
      std::printf("skin %g times stiffer: %.5f, %.5f, %.5f N, without friction %.5f N\n", stiffer, coarse, middle, fine,
                  free);
      // The drag of a tool that grips is small beside a stiff skin, which may lift from the plate there as well.
      EXPECT_GT(fine, law == Friction::Law::grip ? 0.9 * free : free);
      EXPECT_LT(std::abs(middle / fine - 1), stiffer > 1 ? 0.05 : 0.01);
      EXPECT_LT(std::abs(middle / fine - 1), 0.7 * std::abs(coarse / fine - 1) + 2e-3);
    }
}

TEST(WedgedCorner, what_gives_way_loses_the_work_that_the_tools_do) {
  const auto solution = ring_around_cone(16, Friction::Law::grip).solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  double lost = solution.friction_power;
  for (const double w : solution.dissipation) lost += w;
  EXPECT_GT(solution.friction_power, 0);
  EXPECT_NEAR(solution.tool_force[1] * speed / lost, 1, 1e-9);
}

TEST(WedgedCorner, tools_that_move_together_or_along_each_other_without_a_wedge_hold_the_glass_as_it_was) {
  FlowProblem flow = ring_around_cone(8, Friction::Law::stick);
  flow.problem.tools[0].velocity = speed;  // both move: a rigid translation
  auto solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  EXPECT_EQ(solution.friction_power, 0);
  for (auto& candidate : flow.problem.candidates)
    if (candidate.tool == 1) candidate.normal = Point(1, 0);  // a cylinder
  flow.problem.tools[0].velocity = 0;
  solution = flow.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  EXPECT_EQ(solution.friction_power, 0);
}

TEST(WedgedCorner, the_glass_is_held_where_the_corner_is_far) {
  const FlowProblem flow = ring_around_cone(16, Friction::Law::stick);
  FlowProblem solved = flow;
  const auto solution = solved.solve();
  ASSERT_TRUE(solution.converged) << solution.reason;
  int held = 0, sliding = 0;
  for (const Index node : solved.nodes_of("bottom")) {
    const double slip = node_velocity(solution.velocity, node)[0];
    if (solved.mesh.nodes[node][0] - inner > give_way_share * core::size(flow.mesh)) {
      EXPECT_NEAR(slip, 0, 1e-12 * speed);
      ++held;
    } else {
      EXPECT_GT(slip, 0);
      ++sliding;
    }
  }
  EXPECT_GT(held, 4);
  EXPECT_GT(sliding, 4);
}

}  // namespace
}  // namespace parison::flow
