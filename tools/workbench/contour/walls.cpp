// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/contour/walls.hpp"

#include <algorithm>
#include <cmath>

namespace parison::tools {
namespace {

using core::Point;
using Points = std::vector<Point>;

constexpr double on_axis = 1e-7;  // m

/// Its corners, with points between on arcs.
Points points_of(const std::vector<core::Segment>& segments) {
  Points points{segments.front().start};
  for (const core::Segment& segment : segments)
    for (const double t : segment.is_arc ? std::vector<double>{0.25, 0.5, 0.75, 1} : std::vector<double>{1})
      points.push_back(core::point_at(segment, t));
  return points;
}

/// The bore of a plunger from the axis to its shank: its points, moved towards the axis by the thickness. `points` lead
/// from the tip to the shank.
Points bore_behind(const Points& points, double thickness) {
  const double along = points.back()[1] > points.front()[1] ? 1 : -1, least = 0.1 * thickness;
  Points bore;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double behind = along * (points[i][1] - points.front()[1]) - thickness, r = points[i][0] - thickness;
    if (behind < 0 || r < least) continue;
    if (bore.empty()) {
      const double step = along * (points[i][1] - points[i - 1][1]);
      const double back = step > 0 ? std::min(behind / step, 1.0) : 0;  // to where the tip is as thick
      const Point first = points[i] + back * (points[i - 1] - points[i]);
      const bool starts_before = first[0] - thickness >= least && back > 0;
      const double level = starts_before ? first[1] : points[i][1];
      bore.emplace_back(0, level);
      if (starts_before) bore.emplace_back(first[0] - thickness, level);
    }
    if ((Point(r, points[i][1]) - bore.back()).norm() > on_axis) bore.emplace_back(r, points[i][1]);
  }
  return bore;
}

}  // namespace

double Contour::width() const {
  double most = 0;
  for (const Point& x : points_of(segments)) most = std::max(most, x[0]);
  return most;
}

double thickness_behind(const Contour& contour, const std::vector<core::Segment>& others) {
  if (!contour.inside) {
    double most = 0;
    for (const core::Segment& other : others) most = std::max({most, other.start[0], other.end[0]});
    return most - contour.width();
  }
  const Point shank = contour.begin()[0] > contour.end()[0] ? contour.begin() : contour.end();
  double bore = 0;
  for (const core::Segment& other : others)
    for (const Point& x : {other.start, other.end})
      if (std::abs(x[1] - shank[1]) < on_axis && shank[0] - x[0] > on_axis) bore = std::max(bore, x[0]);
  return shank[0] - bore;
}

namespace {

/// The walls from the tip, its end on the axis, to the rim, each without its first point; empty where there are none.
std::vector<Points> from_tip(const Contour& contour, double thickness, const Point& tip, const Point& rim, bool solid) {
  if (!contour.inside) {
    const double r = contour.width() + thickness, level = tip[1] + (tip[1] > rim[1] ? thickness : -thickness);
    return {{{0, level}}, {{r, level}, {r, rim[1]}}, {rim}};
  }
  if (solid) return {{{0, rim[1]}}, {rim}};
  Points points = points_of(contour.segments);
  if (tip == contour.end()) std::reverse(points.begin(), points.end());
  const Points bore = bore_behind(points, thickness);
  if (bore.size() < 2) return {};
  return {{bore.front()}, {bore.begin() + 1, bore.end()}, {rim}};
}

/// The same from the rim to the tip.
std::vector<Points> turned(const std::vector<Points>& walls, const Point& tip) {
  std::vector<Points> back;
  for (std::size_t i = walls.size(); i-- > 0;) {
    back.emplace_back(walls[i].rbegin() + 1, walls[i].rend());
    back.back().push_back(i > 0 ? walls[i - 1].back() : tip);
  }
  return back;
}

}  // namespace

std::optional<std::vector<Points>> walls_behind(const Contour& contour, double thickness, std::size_t count) {
  const Point a = contour.begin(), b = contour.end();
  const bool begins_on_axis = a[0] < on_axis, ends_on_axis = b[0] < on_axis;
  if (!(thickness > 0) || (begins_on_axis && ends_on_axis) || a[1] == b[1]) return {};
  std::vector<Points> walls;
  if (begins_on_axis)
    walls = turned(from_tip(contour, thickness, a, b, count == 2), a);
  else if (ends_on_axis)
    walls = from_tip(contour, thickness, b, a, count == 2);
  else if (const double r = contour.width() + thickness; !contour.inside)
    walls = {{{r, b[1]}}, {{r, a[1]}}, {a}};
  if (walls.size() != count) return {};
  return walls;
}

}  // namespace parison::tools
