// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/contact/interface_cases.hpp"

namespace parison::contact::testing {
namespace {

constexpr double radius = 0.01;

/// Gap of a point over a round tool that touches the line y = 0 at x = top, m.
double round_gap(const Point& x, double top) {
  return std::hypot(x[0] - top, x[1] + radius) - radius;
}

double exact_area(double top) {
  constexpr int parts = 20000;
  double sum = 0;
  for (int i = 0; i < parts; ++i)
    sum += contact_weight(round_gap({0.02 * (i + 0.5) / parts, 0}, top), width) * 0.02 / parts;
  return sum;
}

/// Contact area of flat glass with edges of 2 mm on that tool, over the exact one; its gap known at all points or at
/// the glass's nodes only.
double relative_area(double top, bool everywhere) {
  const auto slave = glass(divided(0, 0.02, 10));
  const auto master = warped(tool(divided(0, 0.02, 40)), [&](const Point& x) {
    return Point(x[0], x[1] - round_gap({x[0], 0}, top));
  });
  const auto gap = [top](const Point& x) { return round_gap(x, top); };
  const SlaveState state = touching(slave, gap);
  Master tool{contact_surface(1, master), state.gap, width, 0};
  if (everywhere) tool.gap_at = gap;
  const auto points =
      contact::build_interface(contact_surface(0, slave), state.pressure, {tool}, core::Geometry::planar);
  return weighted_contact_area(points) / exact_area(top);
}

TEST(ExactGap, the_area_on_a_round_tool_does_not_depend_on_where_the_nodes_of_the_glass_lie) {
  double worst_at_nodes = 0;
  for (double top = 0.009; top < 0.0111; top += 1.3e-4) {
    EXPECT_NEAR(relative_area(top, true), 1, 0.01) << top;
    worst_at_nodes = std::max(worst_at_nodes, std::abs(relative_area(top, false) - 1));
  }
  EXPECT_GT(worst_at_nodes, 0.05);
}

TEST(ExactGap, glass_that_lies_close_has_no_more_points_than_with_gaps_at_its_nodes) {
  const auto slave = glass(divided(0, 0.02, 10)), master = tool(divided(0, 0.02, 7));
  const SlaveState state = touching(slave);
  Master tool{contact_surface(1, master), state.gap, width, 0};
  const auto count = [&] {
    return contact::build_interface(contact_surface(0, slave), state.pressure, {tool}, core::Geometry::planar).size();
  };
  const std::size_t without = count();
  tool.gap_at = [](const Point& x) { return x[1]; };
  EXPECT_EQ(count(), without);
}

}  // namespace
}  // namespace parison::contact::testing
