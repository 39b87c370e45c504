// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <limits>

#include "interface_cases.hpp"

namespace parison::contact::testing {
namespace {

/// CPU seconds to build an interface of `count` by `count - 1` edges; the shortest of several times.
double seconds_of_interface(int count, int times) {
  const auto slave = glass(divided(0, 0.2, count)), master = tool(divided(0, 0.2, count - 1));
  const auto slave_surface = contact_surface(0, slave), master_surface = contact_surface(1, master);
  const auto state = touching(slave);
  double shortest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < times; ++i) {
    const std::clock_t start = std::clock();
    const auto points = build_interface(slave_surface, master_surface, state, {core::Geometry::planar, width, 0});
    shortest = std::min(shortest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    EXPECT_NEAR(weighted_contact_area(points), 0.2, 1e-12);
  }
  return shortest;
}

TEST(MortarCost, an_interface_of_a_thousand_edges_a_side_is_exact_and_quick) {
  const double seconds = seconds_of_interface(1000, 3);
  std::printf("1000 x 999 edges: %.1f ms\n", 1e3 * seconds);
  EXPECT_LT(seconds, 2);
}

/// With a search that compares every slave edge with every master edge it grows about tenfold.
TEST(MortarCost, time_per_edge_hardly_grows_with_their_number) {
  const double few = seconds_of_interface(500, 9) / 500, many = seconds_of_interface(16000, 2) / 16000;
  std::printf("per edge: %.2f us of 500, %.2f us of 16000\n", 1e6 * few, 1e6 * many);
  EXPECT_LT(many, 6 * few);
}

}  // namespace
}  // namespace parison::contact::testing
