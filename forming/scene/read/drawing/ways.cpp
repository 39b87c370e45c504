// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <array>
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

/// Parts the curves that pass a place, or come closest to it.
void part_at(const Point& x, double joined, Chain& curves) {
  double least = HUGE_VAL;
  for (const Segment& curve : curves) least = core::distance(curve, x, least);
  for (std::size_t i = curves.size(); i-- > 0;) {
    if (core::distance(curves[i], x, HUGE_VAL) > least + joined) continue;
    const double t = core::closest_parameter(curves[i], x);
    if (std::min(t, 1 - t) * core::length(curves[i]) <= joined) continue;
    curves.push_back(part_of(curves[i], t, 1));
    curves[i] = part_of(curves[i], 0, t);
  }
}

/// The places at which curves end, and for each curve which two of them are its own.
struct Ends {
  std::vector<Point> places;
  std::vector<std::array<std::size_t, 2>> of_curves;

  /// The place that is closest to a point.
  std::size_t nearest(const Point& x) const {
    const auto is_closer = [&](const Point& a, const Point& b) {
      return (a - x).squaredNorm() < (b - x).squaredNorm();
    };
    return static_cast<std::size_t>(std::min_element(places.begin(), places.end(), is_closer) - places.begin());
  }
};

Ends ends_of(const Chain& curves, double joined) {
  Ends ends;
  const auto place_of = [&](const Point& x) {
    const std::size_t known = ends.nearest(x);
    if (known < ends.places.size() && (ends.places[known] - x).norm() <= joined) return known;
    ends.places.push_back(x);
    return ends.places.size() - 1;
  };
  for (const Segment& curve : curves) ends.of_curves.push_back({place_of(curve.start), place_of(curve.end)});
  return ends;
}

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

std::optional<std::vector<Chain>> ways_between(Chain curves, const Point& from, const Point& to, double gap) {
  constexpr std::size_t most = 1'000'000;  // steps, and curves of all ways
  const double joined = tolerance::joined * size_of(curves);
  for (const Point& x : {from, to}) part_at(x, joined, curves);
  const Ends ends = ends_of(curves, std::max(gap, joined));
  std::vector<std::vector<std::size_t>> follow(ends.places.size());  // the curves at each place
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const std::size_t place : ends.of_curves[i]) follow[place].push_back(i);
  const std::size_t first = ends.nearest(from), last = ends.nearest(to);
  std::vector<std::size_t> way{first}, tried(follow.size());  // its places; of each, how many curves
  std::vector<bool> passed(follow.size());
  Chain along;
  std::vector<Chain> found;
  for (std::size_t step = 0; !way.empty(); ++step) {
    if (step >= most) return {};
    const std::size_t here = way.back();
    passed[here] = true;
    if (here == last && here != first) found.push_back(along), step += along.size();
    if (here == last || tried[here] == follow[here].size()) {
      passed[here] = false, tried[here] = 0;
      way.pop_back();
      if (!along.empty()) along.pop_back();
      continue;
    }
    const std::size_t curve = follow[here][tried[here]++];
    const auto& own = ends.of_curves[curve];
    const std::size_t next = own[own[0] == here];
    if (passed[next]) continue;
    way.push_back(next);
    along.push_back(curves[curve]);
  }
  return found;
}

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
