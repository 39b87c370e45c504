// SPDX-License-Identifier: GPL-3.0-or-later
// The estimated error of a thermal skin that the mesh does not resolve, against that of the program itself.
#include <gtest/gtest.h>

#include <cmath>

#include "thermal/bodies.hpp"
#include "thermal/skin_error.hpp"
#include "thermal/time/tr_bdf2.hpp"

namespace parison::thermal::test {
namespace {

constexpr double conductivity = 1.3, density = 2400, heat_capacity = 1300, start = 1300, air = 300;

/// Error of the heat that a slab on cells of equal height, but for the first two, gives to air through h in a time; the
/// slab is deep.
double error_of_program(double cell, double h, double time, double first = 1) {
  const Material material{density, core::constant(heat_capacity), core::constant(conductivity), {}};
  std::vector<double> heights = divide(0, 40 * cell, 40);
  heights[1] = first * cell;
  const core::Mesh mesh = rectangle({0, cell, 2 * cell}, heights);
  Problem problem{core::Geometry::planar, {body(mesh, material)}, {}, {}};
  problem.bodies[0].exchange.assign(4, std::nullopt);
  problem.bodies[0].exchange[bottom] = SurfaceExchange{h, air};
  StepOptions options;
  options.tolerance = 1e-3;
  options.newton_tolerance = 1e-6;
  StepMatrix matrix;
  const StepOutcome outcome =
      advance(problem, 0, {Eigen::VectorXd::Constant(mesh.node_count(), start)}, time, options, matrix);
  EXPECT_TRUE(outcome.converged) << outcome.reason;
  const double b = h / std::sqrt(conductivity * density * heat_capacity), y = b * std::sqrt(time);
  const double exact =
      2 * cell * h * (start - air) * ((std::exp(y * y) * std::erfc(y) - 1) / (b * b) + 2 * std::sqrt(time / M_PI) / b);
  return outcome.balance.bodies[0].to_air / exact - 1;
}

TEST(SkinError, is_that_of_the_program_within_a_third_and_seldom_less_where_the_skin_is_thinner_than_a_cell) {
  const double diffusivity = conductivity / (density * heat_capacity), cell = 1e-3;
  for (const double fourier : {0.003, 0.01, 0.03, 0.1})
    for (const double biot : {0.3, 3.0, 10.0}) {
      const double time = fourier * cell * cell / diffusivity, h = biot * conductivity / cell;
      const double estimated = skin_error({conductivity, density * heat_capacity, cell, 0}, h, time);
      const double found = error_of_program(cell, h, time);
      std::printf("Fo %g, Bi %g: estimated %.4f, found %.4f\n", fourier, biot, estimated, found);
      EXPECT_GT(estimated, 0.9 * found - 1e-3);
      EXPECT_LT(estimated, 1.35 * found + 1e-3);
    }
}

TEST(SkinError, of_a_first_cell_of_seven_tenths_is_half_as_large_while_the_skin_is_thin_and_small_afterwards) {
  const double diffusivity = conductivity / (density * heat_capacity), cell = 1e-3;
  const auto error = [&](double fourier, double biot, double first) {
    return std::abs(error_of_program(cell, biot * conductivity / cell, fourier * cell * cell / diffusivity, first));
  };
  for (const double biot : {0.5, 2.0, 8.0}) {
    for (const double fourier : {0.03, 0.1}) EXPECT_LT(error(fourier, biot, 0.7), 0.5 * error(fourier, biot, 1));
    for (const double fourier : {0.3, 1.0, 3.0}) EXPECT_LT(error(fourier, biot, 0.7), 1.5e-3);
    EXPECT_GT(error(0.3, biot, 0.4), 2 * error(0.3, biot, 0.7));
  }
}

TEST(SkinError, of_two_bodies_is_that_of_one_where_the_other_conducts_perfectly) {
  const SkinSide glass{conductivity, density * heat_capacity, 1e-3}, perfect{1e7, 1e9, 1e-3};
  for (const double time : {0.01, 0.1, 1.0}) {
    const double one = skin_error(glass, 5000, time);
    EXPECT_NEAR(skin_error(glass, perfect, 5000, time), one, 1e-3 * std::abs(one) + 1e-6);
  }
}

TEST(SkinError, falls_to_nothing_with_time_and_with_the_cell) {
  SkinSide side{conductivity, density * heat_capacity, 1e-3};
  EXPECT_GT(skin_error(side, 1e6, 1e-3), 1);
  EXPECT_LT(std::abs(skin_error(side, 1e6, 10.0)), 1e-3);
  side.first_cell = 1e-5;
  EXPECT_LT(std::abs(skin_error(side, 1e6, 1e-3)), 1e-2);
  EXPECT_EQ(skin_error(side, 0, 1), 0);
}

TEST(SkinError, of_next_to_no_heat_is_next_to_nothing) {
  // Layers of one temperature each: the heat is h times the jump, to the share of their contents that it is.
  const double content = 2400 * 1300, depth = 5e-3, time = 0.5;
  for (const double conducts : {1e4, 1e6, 1e8})
    for (const double h : {1e-6, 1e-3, 1.0, 100.0}) {
      const SkinSide glass{conducts, content, 1e-3, 0.5, depth}, heavy{1e6, 7200e9, 2e-3, 0.5, depth};
      const double share = h * time / (content * depth);
      EXPECT_LT(std::abs(skin_error(glass, heavy, h, time)), 1e-6 + share) << conducts << ' ' << h;
      EXPECT_LT(std::abs(skin_error(glass, h, time)), 1e-6 + share) << conducts << ' ' << h;
    }
}

constexpr double thickness = 10e-3;

/// Heat that a slab of glass has given one of other conductivity and heat capacity, J, both insulated behind and on
/// equal cells.
double heat_between_slabs(double other_conductivity, double other_capacity, int cells, double h, double time) {
  const Material glass{density, core::constant(heat_capacity), core::constant(conductivity), {}};
  const Material other{density, core::constant(other_capacity), core::constant(other_conductivity), {}};
  const std::vector<double> across = divide(0, thickness, 2);
  const core::Mesh upper = rectangle(across, divide(0, thickness, cells));
  const core::Mesh lower = rectangle(across, divide(-thickness, 0, cells));
  Problem problem{core::Geometry::planar, {body(upper, glass), body(lower, other)}, {}, {}};
  problem.interface = stack(upper, lower, problem.geometry);
  problem.law = constant_conductance(h);
  StepOptions options;
  options.tolerance = 1e-2;
  options.newton_tolerance = 1e-6;
  StepMatrix matrix;
  const StepOutcome outcome = advance(
      problem, 0,
      {Eigen::VectorXd::Constant(upper.node_count(), start), Eigen::VectorXd::Constant(lower.node_count(), air)}, time,
      options, matrix);
  EXPECT_TRUE(outcome.converged) << outcome.reason;
  return outcome.balance.pairs[0].received;
}

TEST(SkinError, of_slabs_that_the_heat_crosses_is_not_less_than_that_of_the_program_and_little_more) {
  const double diffusivity = conductivity / (density * heat_capacity), h = 1e6;
  for (const double conducts : {1e-2, 1.0, 1e4})
    for (const double holds : {0.03, 1.0})
      for (const double fourier : {0.001, 0.003, 0.01}) {
        const double time = fourier * thickness * thickness / diffusivity;
        const SkinSide glass{conductivity, density * heat_capacity, 0.25 * thickness, 0, thickness};
        SkinSide other = glass;
        other.conductivity *= conducts;
        other.capacity *= holds;
        const double estimated = skin_error(glass, other, h, time);
        const auto heat = [&](int cells) {
          return heat_between_slabs(other.conductivity, holds * heat_capacity, cells, h, time);
        };
        SkinSide deep_glass = glass, deep_other = other;
        deep_glass.depth = deep_other.depth = std::numeric_limits<double>::infinity();
        const double found = heat(4) / heat(64) - 1, of_half_spaces = skin_error(deep_glass, deep_other, h, time);
        std::printf("conducts %g, holds %g, Fo %g: estimated %.4f, half-spaces %.4f, found %.4f\n", conducts, holds,
                    fourier, estimated, of_half_spaces, found);
        EXPECT_GT(std::abs(estimated), 0.9 * std::abs(found) - 1e-3);
        EXPECT_LT(std::abs(estimated), 1.4 * std::abs(found) + 1.3e-2);
        if (conducts > 1 && holds < 0.1)  // a slab that soon has all the heat that it can hold
          EXPECT_LT(std::abs(estimated - found), 0.1 * std::abs(of_half_spaces - found) + 1.5e-3);
      }
}

/// Highest temperature in a slab of glass a time after it met air, less that of the start, of the drop at the surface.
double overshoot(double cell, double h, double time) {
  const Material material{density, core::constant(heat_capacity), core::constant(conductivity), {}};
  const core::Mesh mesh = rectangle({0, cell, 2 * cell}, divide(0, 40 * cell, 40));
  Problem problem{core::Geometry::planar, {body(mesh, material)}, {}, {}};
  problem.bodies[0].exchange.assign(4, std::nullopt);
  problem.bodies[0].exchange[bottom] = SurfaceExchange{h, air};
  StepOptions options;
  options.tolerance = 1e-2;
  StepMatrix matrix;
  const StepOutcome outcome =
      advance(problem, 0, {Eigen::VectorXd::Constant(mesh.node_count(), start)}, time, options, matrix);
  EXPECT_TRUE(outcome.converged) << outcome.reason;
  const Eigen::VectorXd& temperature = outcome.temperature[0];
  return (temperature.maxCoeff() - start) / (start - temperature.minCoeff());
}

TEST(SkinError, glass_behind_the_skin_is_too_hot_only_until_the_skin_is_a_third_of_the_first_cell) {
  const double diffusivity = conductivity / (density * heat_capacity), cell = 0.7e-3;
  for (const double fourier : {0.001, 0.01, 0.03, 0.1, 0.3, 1.0}) {
    const double time = fourier * cell * cell / diffusivity, found = overshoot(cell, 2e4, time);
    std::printf("Fo %g, %.3f s: %.2f %% of the drop at the surface\n", fourier, time, 100 * found);
    EXPECT_LT(found, fourier < 0.1 ? 0.4 : 0.01);
  }
}

}  // namespace
}  // namespace parison::thermal::test
