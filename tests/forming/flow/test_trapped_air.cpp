// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "flow_case.hpp"

namespace parison::flow {
namespace {

constexpr double ambient = 101325;

TEST(TrappedAirLaw, pressure_times_volume_to_the_exponent_is_kept) {
  for (const double n : {1.0, 1.4})
    for (const double volume : {0.2e-6, 1e-6, 3e-6}) {
      const AirPocket pocket{1e-6, 0.2, n, 0, {}};
      const auto p = pressure_at(pocket, ambient, 1e-3, volume);
      EXPECT_NEAR(p.value * std::pow(volume, n) / (0.2e6 * std::pow(1e-6, n)), 1, 1e-12);
    }
}

TEST(TrappedAirLaw, its_slope_is_the_derivative_and_negative) {
  for (const double vent : {0.0, 1e-6, 1e-3})
    for (const double n : {1.0, 1.4})
      for (const double volume : {1e-7, 0.9e-6, 1.3e-6}) {
        const AirPocket pocket{1e-6, 0.15, n, vent, {}};
        const double h = 1e-6 * volume;
        const double difference = (pressure_at(pocket, ambient, 1e-2, volume + h).value -
                                   pressure_at(pocket, ambient, 1e-2, volume - h).value) /
                                  (2 * h);
        const double slope = pressure_at(pocket, ambient, 1e-2, volume).slope;
        EXPECT_LT(slope, 0);
        EXPECT_NEAR(slope / difference, 1, 1e-4) << vent << ' ' << n << ' ' << volume;
      }
}

TEST(TrappedAirLaw, the_vent_passes_nothing_in_balance_and_is_choked_beyond_the_critical_ratio) {
  EXPECT_EQ(vent_outflow(1, ambient, ambient).value, 0);
  EXPECT_NEAR(vent_outflow(1, 2 * ambient, ambient).value / (2 * ambient), 0.68473, 1e-5);
  EXPECT_NEAR(vent_outflow(1, 5 * ambient, ambient).value / (5 * ambient), 0.68473, 1e-5);
  EXPECT_NEAR(vent_outflow(1, 0.1 * ambient, ambient).value / ambient, -0.68473, 1e-5);
  double last = -1e9;
  for (double p = 0.4 * ambient; p < 3 * ambient; p *= 1.001) {
    const double flow = vent_outflow(1, p, ambient).value;
    EXPECT_GT(flow, last - 1e-9 * ambient);
    last = flow;
  }
}

/// Pressure after a time of choked isothermal outflow from a fixed volume, in steps.
double discharged(int steps, double time) {
  const double volume = 1e-6, vent = 1e-6;
  AirPocket pocket{volume, 6 * ambient * volume, 1, vent, {}};
  for (int i = 0; i < steps; ++i) {
    const double dt = time / steps, p = pressure_at(pocket, ambient, dt, volume).value;
    pocket.energy -= dt * vent_outflow(vent, p, ambient).value;
  }
  return pocket.energy / volume;
}

TEST(TrappedAirLaw, a_choked_vent_discharges_exponentially_to_first_order_in_the_step) {
  const double exact = 6 * ambient * std::exp(-0.6847314563772704 * 1.0);
  const double coarse = discharged(20, 1.0) / exact - 1, fine = discharged(40, 1.0) / exact - 1;
  EXPECT_LT(std::abs(fine), 0.007);
  tests::expect_at_least("order in the step of a choked discharge", std::log2(coarse / fine), 0.95);
}

/// A block of glass 10 mm square on a fixed floor between symmetry planes, its top in contact with a plate.
struct Block : FlowProblem {
  explicit Block(core::Geometry geometry)
      : FlowProblem(tests::structured(6, 6, [](double s, double t) { return Point(0.01 * s, 0.01 * t); }), geometry,
                    1e4) {
    boundary("bottom").kind = BoundaryCondition::Kind::fixed;
    boundary("left").kind = boundary("right").kind = BoundaryCondition::Kind::symmetry;
    problem.tools.push_back({});
    problem.tools[0].friction.law = Friction::Law::slip;
    touch("top", 0, Point(0, -1));
    problem.air = TrappedAir{ambient, 1e-3, {}, {}};
    for (const auto& edge : mesh.boundary_edges())
      problem.air->behind.push_back(mesh.boundaries()[edge.boundary_id].name == "top" ? no_air : open_air);
  }
  double force(const Solution& solution) const { return solution.tool_force[0] + solution.tool_air_force[0]; }
};

TEST(TrappedAir, a_plate_lifted_from_full_contact_pays_ambient_pressure_times_its_area) {
  for (const auto geometry : {core::Geometry::planar, core::Geometry::axisymmetric}) {
    Block block(geometry);
    block.problem.tools[0].velocity = 1e-3;
    const auto solution = block.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    const double area = geometry == core::Geometry::planar ? 0.01 : M_PI * 1e-4;
    tests::expect_at_most("force that lifts a plate off full contact, off from ambient pressure times area",
                          std::abs(block.force(solution) / (ambient * area) - 1), 1e-9);
    EXPECT_TRUE(std::none_of(solution.active.begin(), solution.active.end(), [](bool active) { return active; }));
  }
}

TEST(TrappedAir, a_plate_that_pulls_with_less_than_the_vacuum_does_not_come_off) {
  for (const double share : {0.5, 0.99}) {
    Block block(core::Geometry::axisymmetric);
    block.problem.tools[0].force = share * ambient * M_PI * 1e-4;
    block.problem.tools[0].speed_limit = 1;
    const auto solution = block.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    EXPECT_TRUE(std::all_of(solution.active.begin(), solution.active.end(), [](bool active) { return active; }));
    EXPECT_NEAR(solution.tool_velocity[0], 0, 1e-9);
  }
}

TEST(TrappedAir, a_driven_plate_finds_the_pressure_that_carries_it) {
  // The plate has left the glass; 2 mm of air between them carries its force within one step, however stiff it is.
  for (const double depth : {2e-3, 2e-6}) {
    Block block(core::Geometry::planar);
    block.problem.candidates.clear();
    block.problem.tools[0].force = -200;
    block.problem.tools[0].speed_limit = 10;
    block.problem.air->dt = 1e-2;
    block.problem.air->pockets = {{0.01 * depth, ambient * 0.01 * depth, 1, 0, {0.01}}};
    for (auto& behind : block.problem.air->behind)
      if (behind == no_air) behind = 0;
    const auto solution = block.solve();
    ASSERT_TRUE(solution.converged) << solution.reason;
    EXPECT_NEAR(solution.pockets[0].pressure, ambient + 200 / 0.01, 1e-3);
    EXPECT_NEAR(solution.pockets[0].pressure * solution.pockets[0].volume, ambient * 0.01 * depth, 1e-9 * depth);
    EXPECT_NEAR(block.force(solution), -200, 1e-6);
  }
}

}  // namespace
}  // namespace parison::flow
