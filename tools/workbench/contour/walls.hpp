#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <vector>

#include "core/mesh/profile.hpp"

namespace parison::tools {

/// The side of a tool that the glass may touch, as it is drawn, and on which side of it the tool is.
struct Contour {
  std::vector<core::Segment> segments;
  bool inside;  ///< the tool is between it and the axis, as a plunger is

  core::Point begin() const { return segments.front().start; }
  core::Point end() const { return segments.back().end; }
  double width() const;  ///< largest radius, m
};

/// Thickness of the wall behind a contour of a tool, m: that of the cylinder around it, or that of a shank. `others`
/// are the segments that lead back from its end to its begin.
double thickness_behind(const Contour& contour, const std::vector<core::Segment>& others);

/// The points of each of the boundaries that lead back from the end of a contour to its begin, in their order: axis,
/// wall and face; face, wall and axis; two faces with the wall between them; axis and face of a solid tool. Nothing
/// where `count` is another or the contour is no wall along the axis.
std::optional<std::vector<std::vector<core::Point>>> walls_behind(const Contour& contour, double thickness,
                                                                  std::size_t count);

}  // namespace parison::tools
