// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/case/table.hpp"

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

}  // namespace
}  // namespace parison::core
