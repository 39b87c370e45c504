// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../scene_text.hpp"
#include "core/mesh/element.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/edge_constraints.hpp"

namespace parison::forming {
namespace {

/// Glass far above a tool whose face goes from r = 20 mm, z = 0 to the axis as FACE says.
const std::string faced = R"(case = "faced"
geometry = "axisymmetric"
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
[glass]
material = "liquid"
boundary = [
  { name = "surface", condition = "contact", path = "(0, 50) (10, 50) (10, 60) (0, 60) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 50) mm" } ]
[[tool]]
name = "tool"
friction = "stick"
boundary = [
  { name = "face", condition = "contact", path = "(20, -5) (20, 0) FACE mm" },
  { name = "axis", condition = "symmetry", path = "(0, -5) mm" },
  { name = "rest", condition = "insulated", path = "(20, -5) mm" } ]
[[stage]]
name = "wait"
duration = "1 s"
tools = ["tool"]
)";

struct Placed {
  explicit Placed(const std::string& face)
      : scene(scene_of(replaced("FACE", face, faced))), tools(placed_tools(scene, initial_state(scene))) {}
  Scene scene;
  PlacedTools tools;

  /// The gap of the constraint of an edge, mm.
  double gap(const std::array<Point, 3>& edge_mm) const {
    std::array<Point, 3> edge;
    for (int i = 0; i < 3; ++i) edge[i] = 1e-3 * edge_mm[i];
    const auto found = edge_constraints(tools.tools[0], edge).gentle;
    return found ? 1e3 * found->gap : std::numeric_limits<double>::infinity();
  }
};

TEST(EdgeConstraint, an_edge_that_leaves_a_flat_tool_needs_a_quarter_of_its_open_end_at_the_middle) {
  const Placed flat("(0, 0)");
  // The parabola through 0, m and d at s = 0, 1/2 and 1 has the slope 4 m - d at its start.
  const double open = 0.2, end = 0.125, at_end = 4 * end * (1 - end);
  const auto gap = [&](double middle) { return flat.gap({Point(5, 0), Point(7, open), Point(6, middle)}); };
  EXPECT_NEAR(gap(open / 4), open / 4 - open * end * (1 - 2 * end) / at_end, 1e-12);
  EXPECT_GT(gap(open / 4), 0);
  EXPECT_LT(gap(0.2 * open), 0);
  EXPECT_NEAR(gap(open / 4 + 0.01) - gap(open / 4), 0.01, 1e-12) << "a gap of the middle";
}

TEST(EdgeConstraint, an_edge_on_the_tool_or_away_from_it_asks_for_nothing) {
  const Placed flat("(0, 0)");
  EXPECT_NEAR(flat.gap({Point(5, 0), Point(7, 0), Point(6, 0)}), 0, 1e-15);
  EXPECT_GE(flat.gap({Point(5, 0.3), Point(7, 0.5), Point(6, 0.2)}), 0.2 - 1e-12);
  EXPECT_TRUE(std::isinf(flat.gap({Point(5, 9), Point(7, 9), Point(6, 9)})));
}

TEST(EdgeConstraint, an_edge_with_an_end_inside_the_tool_does_not_ask_for_that_depth) {
  const Placed flat("(0, 0)");
  EXPECT_NEAR(flat.gap({Point(5, -0.01), Point(7, -0.01), Point(6, 0)}), 0, 1e-12);
  EXPECT_LT(flat.gap({Point(5, -0.01), Point(7, -0.01), Point(6, -0.03)}), -0.01);
}

TEST(EdgeConstraint, an_edge_over_a_kink_of_the_tool_needs_the_height_of_the_kink) {
  const Placed roof("(10, 0.5) (0, 0)");  // rises by 1 in 20 from both sides
  const double gap = roof.gap({Point(8.5, 0.425), Point(10.5, 0.475), Point(9.5, 0.475)});
  // At s = 3/4 the edge is at r = 10 mm, 0.4875 mm high, below the kink at 0.5 mm.
  const auto n = core::edge_shape(0.75);
  const double height = n[0] * 0.425 + n[1] * 0.475 + n[2] * 0.475;
  EXPECT_NEAR(gap, (height - 0.5) * std::cos(std::atan(0.05)) / n[2], 1e-3 * std::abs(gap));
}

}  // namespace
}  // namespace parison::forming
