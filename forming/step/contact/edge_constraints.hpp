#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>

#include "forming/step/contact/placed_tools.hpp"

namespace parison::forming {

/// What a tool demands of the middle node of a quadratic edge; none where it demands nothing.
struct EdgeConstraints {
  std::optional<contact::GapConstraint> gentle;      ///< by the eighths of the edge without its middle
  std::optional<contact::GapConstraint> at_corners;  ///< by the middle and by points beside corners of the tool as
                                                     ///< well: holds an edge where it is, but would lift it suddenly
};

/// The constraints of the points of a quadratic edge between its end nodes that demand most of its middle node, so that
/// none is inside the tool. A shift u of the middle moves the edge's point s by N(s) u, with N the middle's shape
/// function, so the gap of the constraint is the gap of that point over N(s), m. Where an end node is inside the tool,
/// the edge is next to it as well: that depth is not asked of the middle. `edge`: first, last, middle, m. A tool
/// farther away than the edge is long demands nothing.
EdgeConstraints edge_constraints(const PlacedTools::Tool& tool, const std::array<Point, 3>& edge);

}  // namespace parison::forming
