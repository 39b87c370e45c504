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
  double most = 0, least = 0;  // radii
  for (const core::Segment& curve : placed)
    for (const double t : {0.0, 0.5, 1.0}) {
      const double r = core::point_at(curve, t)[0];
      most = std::max(most, r), least = std::min(least, r);
    }
  if (table.find("axis") && !is_cut && least < 0 && most <= tolerance::joined * size_of(placed)) {
    // A reflection at the axis behind the turn is one before it and the opposite turn.
    placement.mirrored = true;
    placement.turn = -placement.turn;
    placed = all(placement);
  }
  curves = std::move(placed);
}

}  // namespace parison::forming
