// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
using core::Point;
using core::Segment;

/// The way that passes a place, or comes much nearer to it than any other.
Chain way_next_to(const CaseNode& place, const std::vector<Chain>& ways) {
  const Point via = read_point(place);
  std::vector<std::pair<double, std::size_t>> by_distance;
  for (const Chain& way : ways) {
    double found = HUGE_VAL;
    for (const Segment& curve : way) found = core::distance(curve, via, found);
    by_distance.emplace_back(found, by_distance.size());
  }
  std::sort(by_distance.begin(), by_distance.end());
  const double least = by_distance[0].first, second = by_distance[1].first;
  if (2 * least < second) return ways[by_distance[0].second];
  core::refuse(place, fmt::format("{} is {:.3g} mm away from one way round the outline and {:.3g} mm from the other, "
                                  "allowed is a place on or next to one of them",
                                  place.text, 1e3 * least, 1e3 * second));
}

}  // namespace

std::optional<Chain> wanted_way(const CaseTable& table, const std::vector<Chain>& ways) {
  if (const auto* via = table.find("via")) return way_next_to(*via, ways);
  const double axis = 2 * tolerance::on_drawing * size_of(ways[0]);
  for (const char* key : {"from", "to"})
    if (std::abs(read_point(table.get(key))[0]) > axis) return {};
  const auto is_right = [&](const Chain& way) {
    return std::all_of(way.begin(), way.end(), [&](const Segment& curve) {
      return std::min({curve.start[0], core::point_at(curve, 0.5)[0], curve.end[0]}) >= -axis;
    });
  };
  const auto found = std::find_if(ways.begin(), ways.end(), is_right);
  if (std::count_if(ways.begin(), ways.end(), is_right) != 1) return {};
  return *found;
}

}  // namespace parison::forming
