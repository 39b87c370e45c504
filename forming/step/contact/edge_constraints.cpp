// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/edge_constraints.hpp"

#include "core/mesh/element.hpp"
#include "forming/step/contact/penetration.hpp"

namespace parison::forming {

EdgeConstraints edge_constraints(const PlacedTools::Tool& tool, const std::array<Point, 3>& edge) {
  const double length = (edge[1] - edge[0]).norm();
  const std::array<Point, 3> local{edge[0] - tool.shift, edge[1] - tool.shift, edge[2] - tool.shift};
  std::optional<std::array<double, 2>> inside;  // depth of the end nodes, m
  const auto depths = [&]() -> const std::array<double, 2>& {
    if (!inside) {
      inside.emplace();
      for (int end = 0; end < 2; ++end) {
        const auto found = tool.constraints(local[end], length);
        (*inside)[end] = found.empty() ? 0 : std::max(0.0, -found.front().gap);
      }
    }
    return *inside;
  };
  const auto take_lesser = [](std::optional<contact::GapConstraint>& least, const contact::GapConstraint& there) {
    if (!least || there.gap < least->gap) least = there;
  };
  EdgeConstraints least;
  constexpr double middle = 0.5;
  std::size_t place = 0;
  for (const double s : places_on(local, *tool.profile)) {
    const bool beside_corner = place++ >= edge_eighths.size();
    if (s <= 0 || s >= 1) continue;
    const auto n = core::edge_shape(s);
    const Point x = n[0] * edge[0] + n[1] * edge[1] + n[2] * edge[2];
    auto found = tool.constraints(x - tool.shift, length);
    if (found.empty()) continue;
    contact::GapConstraint& there = found.front();
    if (there.gap < 0) there.gap = std::min(0.0, there.gap + (1 - s) * depths()[0] + s * depths()[1]);
    there.gap /= n[2];
    take_lesser(least.at_corners, there);
    if (!beside_corner && s != middle) take_lesser(least.gentle, there);
  }
  return least;
}

}  // namespace parison::forming
