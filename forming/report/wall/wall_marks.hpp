#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <initializer_list>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "forming/report/thickness_profile.hpp"
#include "remesh/wall/wall_sides.hpp"

namespace parison::forming {

using core::Index;
using core::Point;

/// Where a walk along the boundary towards a rim begins.
struct RimApproach {
  Index edge;       ///< boundary edge of the outer side, walked whole
  double arc;       ///< of the end of the edge at which the walk begins, m
  bool forwards;    ///< in the order of the boundary; arcs fall otherwise
  Point direction;  ///< of the wall, towards the rim, of unit length
  double steady;    ///< length over which the surface must keep its direction to count as the other side, m
};

/// The arc, m, of the middle of the rim: of a rim that is held, of its boundary; of a free one half-way between where
/// the surface has turned by 60 degrees from the wall's direction and where it has by 120, for the last time in both
/// cases, as glass may swell over a rim that is held. It depends on the shape alone, while the edges that count as rim
/// depend on where the mesh has its nodes. Not a number where the surface does not turn so far on its way to a symmetry
/// boundary.
double rim_middle(const core::Mesh& mesh, const RimApproach& approach);

/// What glass needs to be a wall, its length over its thickness. Each stretch beside a longer one needs that too. A
/// round roll is as long as thick: near that, the mesh would decide.
inline constexpr double least_wall_length = 1.5;

/// By boundary edge: whether it is one of the wanted parts.
std::vector<bool> edges_of(const remesh::WallSides& sides, std::initializer_list<remesh::SurfacePart> wanted);

/// Gives the rows, with their nodes, mark, thickness and the place on the inner side by the rays through the glass, and
/// moves area between the last row of the wall and the next, so that the wall ends at a corner or where its sides turn
/// away and not at a node; feet that are hardly any leave theirs to the wall.
void mark_wall(const core::Mesh& mesh, core::Geometry geometry, const remesh::WallSides& sides,
               const std::vector<remesh::Ray>& rays, const std::vector<Index>& nodes, std::vector<ThicknessRow>& rows);

/// Length of all stretches of marked rows that are wall, mirror images included, m.
double wall_length(const core::Mesh& mesh, const std::vector<Index>& nodes, const std::vector<ThicknessRow>& rows);

}  // namespace parison::forming
