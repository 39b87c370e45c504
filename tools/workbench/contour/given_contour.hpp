#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// A contour of a drawing beside a case, in the words of a `path` of a case; empty ones are left out.
struct DrawnContour {
  std::string file, unit, layer, from, via, to, origin, axis, turn;
  std::string thickness;       ///< of the wall behind it; empty: that of the tool so far
  bool as_points = false;      ///< the case gets its points and arcs, without the drawing
  bool with_sections = false;  ///< those of a tool that is not round are measured on the solid too
};

/// What gives a contour to a boundary of a tool, `tool.2.boundary.0.path`, as assignments for core::override_value. It
/// runs as that of the boundary did. Where it is the side that the glass may touch,
/// * a tool with a position keeps the place of its end on the axis: a plunger may be drawn where it stops,
/// * the axis, the cooled wall and the face behind it follow where its ends or its width are others, with the thickness
///   that the tool had or the one asked for. A tool of other boundaries keeps them, or is refused where a thickness is
///   asked for.
std::vector<std::string> given_contour(const std::string& case_file, const std::string& key,
                                       const DrawnContour& contour);

}  // namespace parison::tools
