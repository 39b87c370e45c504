// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/case/table.hpp"
#include "core/case/time_function.hpp"

namespace parison::core {
namespace {

TEST(Table, kinks_are_the_corners_of_a_curve_and_its_ends) {
  const Table corner{{0, 0.2, 0.3, 0.6}, {10, 8, 7, 5.5}};  // slopes -10, -10, -5
  EXPECT_EQ(kinks(corner, 0.05), (std::vector<double>{0, 0.3, 0.6}));
}

TEST(Table, a_smooth_curve_has_no_kinks_however_many_entries_it_is_given_by) {
  Table smooth;
  for (int i = 0; i <= 200; ++i) {
    smooth.x.push_back(0.01 * i);
    smooth.y.push_back(1 - std::cos(M_PI * 0.01 * i));
  }
  EXPECT_TRUE(kinks(smooth, 0.05).empty());
  EXPECT_TRUE(kinks(constant(3), 0.05).empty());
}

TEST(Table, its_value_is_on_the_line_between_the_entries_around_it_however_uneven_they_are) {
  Table even{{0}, {0}}, uneven = even, with_a_gap = even;
  for (int i = 1; i <= 500; ++i) {
    even.x.push_back(0.1 * i);
    uneven.x.push_back(std::pow(1.02, i));
    with_a_gap.x.push_back(i < 250 ? 1e-3 * i : 100 + 5 * i);
    for (Table* table : {&even, &uneven, &with_a_gap}) table->y.push_back(std::sin(i));
  }
  for (const Table* table : {&even, &uneven, &with_a_gap})
    for (std::size_t i = 0; i + 1 < table->x.size(); ++i)
      for (const double share : {0.0, 1e-9, 0.37, 1 - 1e-9}) {
        const double wide = table->x[i + 1] - table->x[i], rise = table->y[i + 1] - table->y[i];
        const double at = table->x[i] + share * wide;
        EXPECT_NEAR((*table)(at), table->y[i] + rise * (at - table->x[i]) / wide, 1e-12);
        EXPECT_DOUBLE_EQ(table->derivative(at), rise / wide);
      }
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(even(unknown)));
}

TEST(Table, its_integral_is_exact_between_and_beyond_the_entries) {
  const Table table{{1, 2, 4}, {10, 20, 0}};
  EXPECT_DOUBLE_EQ(table.integral(0), -10);
  EXPECT_DOUBLE_EQ(table.integral(1), 0);
  EXPECT_DOUBLE_EQ(table.integral(1.5), 0.5 * (10 + 15) / 2);
  EXPECT_DOUBLE_EQ(table.integral(2), 15);
  EXPECT_DOUBLE_EQ(table.integral(3), 15 + (20 + 10) / 2.);
  EXPECT_DOUBLE_EQ(table.integral(4), 35);
  EXPECT_DOUBLE_EQ(table.integral(9), 35);
  EXPECT_DOUBLE_EQ((Table{{1, 2}, {10, 20}}).integral(5), 15 + 3 * 20);
  EXPECT_DOUBLE_EQ(constant(3).integral(2), 6);
}

TEST(Table, its_mean_is_exact_across_its_entries_and_beyond_its_ends) {
  const Table table{{1, 2, 4}, {0, 6, 2}};
  EXPECT_DOUBLE_EQ(mean(table, 0, 1), 0);
  EXPECT_DOUBLE_EQ(mean(table, 1.5, 3), (0.5 * 4.5 + 5.0) / 1.5);
  EXPECT_DOUBLE_EQ(mean(table, 0, 6), (3 + 8 + 4) / 6.0);
  for (const auto& [from, to] : {std::pair{0.2, 1.3}, {1.2, 1.4}, {3.5, 9.0}})
    EXPECT_NEAR(mean(table, from, to), (table.integral(to) - table.integral(from)) / (to - from), 1e-14);
}

TEST(Table, corners_are_few_on_a_smooth_curve_and_no_noise_but_every_pulse) {
  Table noisy;
  for (int i = 0; i <= 1000; ++i) {
    noisy.x.push_back(0.001 * i);
    noisy.y.push_back(std::sin(M_PI * 0.001 * i) + (i % 2 ? 0.004 : -0.004));
  }
  EXPECT_LT(corners(noisy, 0.02).size(), 12u);
  noisy.y[500] += 1;
  const auto at = corners(noisy, 0.02);
  EXPECT_TRUE(std::count(at.begin(), at.end(), noisy.x[500])) << "the pulse";
  const Table ramp{{0, 1, 2, 3}, {0, 1, 2, 2}};
  EXPECT_EQ(corners(ramp, 0.02), (std::vector<double>{0, 2, 3}));
  EXPECT_TRUE(corners(constant(3), 0.02).empty());
}

TEST(TimeFunction, a_constant_keeps_its_bits_in_the_mean_and_has_no_corner) {
  const TimeFunction constant = 0.1 + 0.2;
  EXPECT_EQ(constant.mean(0.3, 0.7), 0.1 + 0.2);
  EXPECT_TRUE(std::isinf(constant.next_corner(0)));
  const TimeFunction later = TimeFunction(Table{{0, 1}, {3, -5}}).later(2);
  EXPECT_DOUBLE_EQ(later(2.5), -1);
  EXPECT_DOUBLE_EQ(later.next_corner(2), 3);
  EXPECT_DOUBLE_EQ(later.max_size(), 5);
}

}  // namespace
}  // namespace parison::core
