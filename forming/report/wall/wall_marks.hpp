#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <initializer_list>
#include <vector>

#include "forming/report/thickness_profile.hpp"
#include "forming/report/wall/wall_sides.hpp"

namespace parison::forming {

/// What glass needs to be a wall, its length over its thickness. Each stretch beside a longer one needs that too. A
/// round roll is as long as thick: near that, the mesh would decide.
inline constexpr double least_wall_length = 1.5;

/// By boundary edge: whether it is one of the wanted parts.
std::vector<bool> edges_of(const WallSides& sides, std::initializer_list<SurfacePart> wanted);

/// Gives the rows, with their nodes, mark, thickness and the place on the inner side by the rays through the glass, and
/// moves area between the last row of the wall and the next, so that the wall ends at a corner or where its sides turn
/// away and not at a node; feet that are hardly any leave theirs to the wall.
void mark_wall(const core::Mesh& mesh, core::Geometry geometry, const WallSides& sides, const std::vector<Ray>& rays,
               const std::vector<Index>& nodes, std::vector<ThicknessRow>& rows);

/// Length of all stretches of marked rows that are wall, mirror images included, m.
double wall_length(const core::Mesh& mesh, const std::vector<Index>& nodes, const std::vector<ThicknessRow>& rows);

}  // namespace parison::forming
