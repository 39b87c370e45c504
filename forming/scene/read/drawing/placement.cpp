// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/drawing/placement.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "forming/scene/read/drawing/read_section.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {
namespace {

using core::Point;

struct AxisTurn {
  const char* axis;
  double turn;  ///< that brings the direction to that of z, rad
};
constexpr std::array axis_turns{AxisTurn{"y", 0}, AxisTurn{"x", M_PI / 2}, AxisTurn{"-y", M_PI},
                                AxisTurn{"-x", -M_PI / 2}};

double turn_of_axis(const core::CaseNode& axis) {
  const auto found = std::find_if(axis_turns.begin(), axis_turns.end(),
                                  [&](const AxisTurn& turn) { return core::text(axis) == turn.axis; });
  if (found == axis_turns.end())
    core::refuse(axis, fmt::format("\"{}\" was found, allowed is the direction of the drawing that is z of the case: "
                                   "\"x\", \"-x\", \"y\" or \"-y\" (and turn for any other)",
                                   axis.text));
  return found->turn;
}

}  // namespace

core::Segment Placement::operator()(const core::Segment& segment) const {
  const auto turned = [&](const Point& x) {
    const Point own(mirrored ? -x[0] : x[0], x[1]);
    return Point(std::cos(turn) * own[0] - std::sin(turn) * own[1], std::sin(turn) * own[0] + std::cos(turn) * own[1]);
  };
  const auto placed = [&](const Point& x) -> Point { return place + scale * turned(x - base); };
  core::Segment result = segment;
  result.start = placed(segment.start);
  result.end = placed(segment.end);
  if (!segment.is_arc) return result;
  result.centre = placed(segment.centre);
  result.radius = scale * segment.radius;
  const Point first = turned({std::cos(segment.from), std::sin(segment.from)});
  result.from = std::atan2(first[1], first[0]);
  result.to = result.from + (mirrored ? -1 : 1) * (segment.to - segment.from);
  return result;
}

namespace {

Placement read_placement(const core::CaseTable& table, bool is_cut) {
  Placement placement;
  const auto *origin = table.find("origin"), *axis = table.find("axis"), *turn = table.find("turn");
  if (origin) placement.base = read_point(*origin);
  if (is_cut) return placement;
  if (axis && turn) core::refuse(*turn, "axis and turn were found, allowed is one of them");
  if (axis) placement.turn = turn_of_axis(*axis);
  if (turn) placement.turn = core::quantity(*turn, core::dimension::none);
  return placement;
}

/// How far `from` and `to` are from the curves that reach positive radii, m; infinite where there are none.
double distance_of_places(const core::CaseTable& table, const std::vector<core::Segment>& curves) {
  const double axis = tolerance::joined * size_of(curves);
  const auto is_right = [&](const core::Segment& curve) {
    return std::max({curve.start[0], core::point_at(curve, 0.5)[0], curve.end[0]}) > axis;
  };
  double farthest = 0;
  for (const auto* node : {&table.get("from"), table.find("to")}) {
    if (!node) continue;
    double nearest = HUGE_VAL;
    for (const core::Segment& curve : curves)
      if (is_right(curve)) nearest = core::distance(curve, read_point(*node), nearest);
    farthest = std::max(farthest, nearest);
  }
  return farthest;
}

}  // namespace

void place(const core::CaseTable& table, bool is_cut, std::vector<core::Segment>& curves) {
  if (!table.find("origin") && !table.find("axis") && !table.find("turn")) return;
  Placement placement = read_placement(table, is_cut);
  const auto all = [&](const Placement& by) {
    std::vector<core::Segment> placed;
    std::transform(curves.begin(), curves.end(), std::back_inserter(placed), by);
    return placed;
  };
  std::vector<core::Segment> placed = all(placement);
  if (table.find("axis") && !is_cut) {
    // A reflection at the axis behind the turn is one before it and the opposite turn.
    placement.mirrored = true;
    placement.turn = -placement.turn;
    std::vector<core::Segment> reflected = all(placement);
    const double near = tolerance::on_drawing * size_of(placed);
    if (distance_of_places(table, reflected) + near < distance_of_places(table, placed)) placed = std::move(reflected);
  }
  curves = std::move(placed);
}

}  // namespace parison::forming
