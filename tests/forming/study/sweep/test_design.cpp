// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "forming/study/sweep/design.hpp"

namespace parison::forming {
namespace {

std::vector<double> column(const DesignPoints& points, std::size_t variable) {
  std::vector<double> values;
  for (const auto& point : points) values.push_back(point[variable]);
  return values;
}

/// How many points lie in each of `parts` equal parts of a variable.
std::vector<int> counts(const DesignPoints& points, std::size_t variable, int parts) {
  std::vector<int> found(static_cast<std::size_t>(parts), 0);
  for (const double value : column(points, variable)) ++found.at(static_cast<std::size_t>(value * parts));
  return found;
}

TEST(Design, each_part_of_each_variable_of_a_latin_hypercube_has_one_point) {
  const DesignPoints points = latin_hypercube(3, 40, 7);
  ASSERT_EQ(points.size(), 40u);
  for (std::size_t variable = 0; variable < 3; ++variable)
    EXPECT_EQ(counts(points, variable, 40), std::vector<int>(40, 1)) << variable;
  EXPECT_NE(column(points, 0), column(points, 1));
}

TEST(Design, a_seed_gives_its_points_again_and_another_seed_others) {
  EXPECT_EQ(latin_hypercube(4, 25, 1), latin_hypercube(4, 25, 1));
  EXPECT_NE(latin_hypercube(4, 25, 1), latin_hypercube(4, 25, 2));
  EXPECT_EQ(sobol_sequence(4, 25, 3), sobol_sequence(4, 25, 3));
  EXPECT_NE(sobol_sequence(4, 25, 3), sobol_sequence(4, 25, 0));
  EXPECT_NE(sobol_sequence(4, 25, 3), sobol_sequence(4, 25, 2));
}

TEST(Design, the_sobol_sequence_is_that_of_the_literature) {
  // The first points behind the origin: I. M. Sobol, USSR Comput. Math. Math. Phys. 7 (1967) 86-112.
  const DesignPoints points = sobol_sequence(2, 3, 0);
  EXPECT_EQ(points[0], (std::vector<double>{0.5, 0.5}));
  std::set<std::vector<double>> next{points[1], points[2]};
  EXPECT_EQ(next, (std::set<std::vector<double>>{{0.25, 0.75}, {0.75, 0.25}}));
}

TEST(Design, more_runs_of_a_sobol_sequence_begin_with_the_points_of_fewer) {
  for (const std::uint64_t seed : {0u, 11u}) {
    const DesignPoints few = sobol_sequence(5, 16, seed), many = sobol_sequence(5, 64, seed);
    EXPECT_TRUE(std::equal(few.begin(), few.end(), many.begin()));
  }
}

TEST(Design, sobol_points_integrate_a_smooth_function_better_than_their_number_of_random_ones) {
  constexpr std::size_t runs = 1023;
  for (const std::uint64_t seed : {0u, 1u, 2u}) {
    double sum = 0;
    for (const auto& point : sobol_sequence(3, runs, seed)) sum += std::exp(point[0]) * point[1] * std::cos(point[2]);
    const double exact = (std::exp(1.0) - 1) * 0.5 * std::sin(1.0);
    EXPECT_NEAR(sum / runs, exact, 0.005 * exact) << seed;  // random ones: 2 % by one standard deviation
  }
}

TEST(Design, a_grid_has_each_combination_once_with_the_last_variable_fastest) {
  const auto rows = full_grid({2, 3});
  ASSERT_EQ(rows.size(), 6u);
  EXPECT_EQ(rows[1], (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(std::set(rows.begin(), rows.end()).size(), 6u);
}

}  // namespace
}  // namespace parison::forming
