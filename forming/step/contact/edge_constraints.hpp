#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>

#include "forming/step/contact/placed_tools.hpp"

namespace parison::forming {

/// What a tool demands of the middle node of a quadratic edge so that no point of the edge between its end nodes is
/// inside the tool: the constraint of the point that demands most. A shift u of the middle moves the edge's point s by
/// N(s) u, with N the middle's shape function, so the gap of the constraint is the gap of that point over N(s), m.
/// Where an end node is inside the tool, the edge is next to it as well: that depth is not asked of the middle. `edge`:
/// first, last, middle, m. A tool farther away than the edge is long demands nothing. Points beside corners of the tool
/// are asked where `at_corners` says so: what they demand holds an edge where it is, but would lift it suddenly.
std::optional<contact::GapConstraint> edge_constraint(const PlacedTools::Tool& tool, const std::array<Point, 3>& edge,
                                                      bool at_corners = false);

}  // namespace parison::forming
