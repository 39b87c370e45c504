// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/edge_constraints.hpp"

#include "core/mesh/element.hpp"
#include "forming/step/contact/penetration.hpp"

namespace parison::forming {

namespace {

/// Places on an edge that are asked, besides the middle.
const std::vector<double> asked{0.125, 0.25, 0.375, 0.625, 0.75, 0.875};

}  // namespace

std::optional<contact::GapConstraint> edge_constraint(const PlacedTools::Tool& tool, const std::array<Point, 3>& edge,
                                                      bool at_corners) {
  const double length = (edge[1] - edge[0]).norm();
  std::optional<contact::GapConstraint> least;
  std::array<double, 2> inside{0, 0};  // depth of the end nodes, m
  for (int end = 0; end < 2; ++end) {
    const auto found = tool.constraints(edge[end] - tool.shift, length);
    if (!found.empty()) inside[end] = std::max(0.0, -found.front().gap);
  }
  const std::array<Point, 3> local{edge[0] - tool.shift, edge[1] - tool.shift, edge[2] - tool.shift};
  for (const double s : at_corners ? places_on(local, *tool.profile) : asked) {
    if (s <= 0 || s >= 1) continue;
    const auto n = core::edge_shape(s);
    const Point x = n[0] * edge[0] + n[1] * edge[1] + n[2] * edge[2];
    auto found = tool.constraints(x - tool.shift, length);
    if (found.empty()) continue;
    contact::GapConstraint& there = found.front();
    if (there.gap < 0) there.gap = std::min(0.0, there.gap + (1 - s) * inside[0] + s * inside[1]);
    there.gap /= n[2];
    if (!least || there.gap < least->gap) least = there;
  }
  return least;
}

}  // namespace parison::forming
