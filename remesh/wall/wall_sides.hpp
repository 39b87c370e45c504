#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "remesh/wall/surface_rays.hpp"

namespace parison::remesh {

/// What a boundary edge is of a wall: one of its two sides, a rim between them, or neither (a symmetry boundary, a
/// bubble).
enum class SurfacePart { none, outer, inner, rim };

/// The two sides of a wall, found from the section's shape alone.
struct WallSides {
  std::vector<SurfacePart> part;  ///< by boundary edge; all `none` without a wall
  std::vector<bool> paired;       ///< by node: the sides were found from pairs there; more of a side may lie beyond
  bool is_mirrored = false;       ///< the wall is half of itself, its inner side the mirror image of the outer one
  std::string no_wall;            ///< why there is none, a sentence; empty with a wall
};

/// Rays of surface nodes that meet the surface again face to face pair positions of it. The chain of boundary edges
/// between symmetry boundaries is cut where most pairs are parted: there are the rims, each from the corner, or the
/// bend, where one side ends to where the other does. Where two chains face each other (a shell between symmetry
/// boundaries, a ring) they are the sides. The inner side is the one that looks into a cavity; of a flat wall the upper
/// one. `rays` are those of surface_rays for the same mesh.
WallSides wall_sides(const core::Mesh& mesh, core::Geometry geometry, const std::vector<Ray>& rays);

/// Least cosine between a ray and the normal at its end where two sides of a wall face each other: an end face looks
/// along the wall, not through it.
inline constexpr double facing_sides = 0.8;

}  // namespace parison::remesh
