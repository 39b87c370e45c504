// SPDX-License-Identifier: GPL-3.0-or-later
// The estimated error of heat that a surface exchanges in pulses and stages, against the program itself.
#include <gtest/gtest.h>

#include <cmath>

#include "thermal/bodies.hpp"
#include "thermal/skin_history.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

constexpr double conductivity = 1.3, density = 2400, heat_capacity = 1300, start = 1300, air = 300, thickness = 8e-3;

SkinSide layer(double cell) {
  return {conductivity, density * heat_capacity, cell, 0, thickness};
}

SkinInterval steady(double time, double h, double temperature = air) {
  return {time, {h, temperature}, {h, temperature}};
}

/// Heat that a slab on equal cells gives to air in a history of constant intervals, J/m2.
double heat_of_program(double cell, const SkinHistory& history) {
  const Material material{density, core::constant(heat_capacity), core::constant(conductivity), {}};
  const int cells = static_cast<int>(std::lround(thickness / cell));
  const core::Mesh mesh = rectangle({0, 1e-3, 2e-3}, divide(0, thickness, cells));
  Problem problem{core::Geometry::planar, {body(mesh, material)}, {}, {}};
  StepOptions options;
  options.tolerance = 1e-3;
  options.newton_tolerance = 1e-6;
  StepMatrix matrix;
  std::vector<Eigen::VectorXd> temperature{Eigen::VectorXd::Constant(mesh.node_count(), start)};
  double heat = 0, time = 0;
  for (const SkinInterval& interval : history) {
    problem.bodies[0].exchange.assign(4, std::nullopt);
    problem.bodies[0].exchange[bottom] = SurfaceExchange{interval.start.h, interval.start.temperature};
    const StepOutcome outcome = advance(problem, time, temperature, interval.duration, options, matrix);
    EXPECT_TRUE(outcome.converged) << outcome.reason;
    temperature = outcome.temperature;
    heat += outcome.balance.bodies[0].to_air / 2e-3;
    time += interval.duration;
  }
  return heat;
}

SkinHistory pulses(double h, double rest_h, double width, double rest, int count) {
  SkinHistory history;
  for (int i = 0; i < count; ++i) {
    history.push_back(steady(width, h));
    history.push_back(steady(rest, rest_h));
  }
  return history;
}

TEST(SkinHistory, the_error_of_pulses_is_that_of_the_program) {
  for (const double width : {0.02, 0.05, 0.2})
    for (const double rest_h : {0.0, 50.0}) {
      const SkinHistory history = pulses(5000, rest_h, width, 1 - width, 4);
      const double found = heat_of_program(1e-3, history) / heat_of_program(0.04e-3, history) - 1;
      const double estimated = skin_error(layer(1e-3), start, history);
      std::printf("%g s of each second, %g W/m2K between: estimated %.4f, found %.4f\n", width, rest_h, estimated,
                  found);
      EXPECT_GT(estimated, 0.9 * std::abs(found) - 1e-3);
      EXPECT_LT(estimated, 1.3 * std::abs(found) + 3e-3);
    }
}

TEST(SkinHistory, of_one_interval_the_error_is_that_of_exchange_that_begins_and_stays) {
  for (const double time : {0.05, 0.3, 3.0})
    for (const double h : {300.0, 3000.0, 1e5}) {
      const double constant = std::abs(skin_error(layer(1e-3), h, time));
      EXPECT_NEAR(skin_error(layer(1e-3), start, {steady(time, h)}), constant, 0.03 * constant + 5e-4)
          << h << ' ' << time;
    }
}

TEST(SkinHistory, without_exchange_there_is_no_error) {
  EXPECT_EQ(skin_error(layer(1e-3), start, {}), 0);
  EXPECT_EQ(skin_error(layer(1e-3), start, {steady(1, 0)}), 0);
  EXPECT_EQ(skin_error(layer(1e-3), start, {steady(1, 500, start)}), 0);
}

TEST(SkinHistory, cells_that_fit_are_those_of_the_shortest_event_and_all_smaller_ones_fit_too) {
  const double whole = fitting_first_cell(layer(1e-3), start, {steady(10, 5000)}, 3e-3);
  const SkinHistory history = pulses(5000, 0, 0.05, 0.95, 10);
  const double pulsed = fitting_first_cell(layer(1e-3), start, history, 3e-3);
  EXPECT_LT(pulsed, 0.5 * whole);
  for (double cell = pulsed; cell > 0.2 * pulsed; cell *= 0.7)
    EXPECT_LE(skin_error(layer(cell), start, history), 3.3e-3);
  const SkinHistory then_long{steady(0.2, 1000), steady(9.8, 0)};
  const double of_short = fitting_first_cell(layer(1e-3), start, then_long, 3e-3);
  EXPECT_LT(of_short, whole);
  EXPECT_LE(skin_error(layer(of_short), start, then_long), 3e-3);
  EXPECT_GT(skin_error(layer(whole), start, then_long), 3e-3);
}

TEST(SkinHistory, a_coarse_cell_is_not_taken_because_its_error_changes_its_sign) {
  // Between two coarse cells the error of the heat passes through nothing.
  for (const double time : {1.0, 3.0, 10.0, 30.0})
    for (const double h : {1e3, 1e4, 1e5}) {
      double last = 1e-2;
      for (double wanted = 1e-2; wanted > 1e-4; wanted *= 0.9) {
        SkinSide side{conductivity, density * heat_capacity, wanted};
        const double fitting = fitting_first_cell(side, start, {steady(time, h)}, 3e-3);
        EXPECT_LT(fitting, 1.6 * last) << "a finer mesh asked for is not coarser";
        last = std::min(last, fitting);
      }
    }
}

}  // namespace
}  // namespace parison::thermal::test
