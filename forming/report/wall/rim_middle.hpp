#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

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

}  // namespace parison::forming
