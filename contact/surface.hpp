#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/mesh.hpp"

namespace parison::contact {

using core::Index;
using core::Point;

/// Quadratic edge of a body's surface, the body on its left.
struct SurfaceEdge {
  std::array<Index, 3> nodes;  ///< first, last, mid, in the numbering of the body's mesh
  std::array<Point, 3> x;      ///< their positions, m
};

/// The part of a body's surface that may touch another body, at one instant; nothing changes it.
struct Surface {
  Index body;
  std::vector<SurfaceEdge> edges;
};

/// The edges of the pieces in contact (one flag for each of mesh.pieces), moved by `displacement`, m.
Surface make_surface(Index body, const core::Mesh& mesh, const std::vector<bool>& pieces_in_contact,
                     const Point& displacement);

/// Position, m, and its derivative with respect to s in [0, 1].
Point position(const SurfaceEdge& edge, double s);
Point slope(const SurfaceEdge& edge, double s);
/// Outward unit normal.
Point normal(const SurfaceEdge& edge, double s);

}  // namespace parison::contact
