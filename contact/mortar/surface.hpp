#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::contact {

using core::Index;
using core::Point;

/// Quadratic edge of a body's surface, the body on its left.
struct SurfaceEdge {
  std::array<Index, 3> nodes;  ///< first, last, mid, in the numbering of the body's mesh
  std::array<Point, 3> x;      ///< their positions, m
};

/// The part of a body's surface that may touch another body, at one instant.
struct Surface {
  Index body;
  std::vector<SurfaceEdge> edges;
};

/// The edges of the boundaries that may touch another body (one flag for each boundary of the mesh), moved by
/// `displacement`, m.
Surface make_surface(Index body, const core::Mesh& mesh, const std::vector<bool>& boundaries_in_contact,
                     const Point& displacement);

/// Position on an edge, m, and its derivative with respect to the parameter s in [0, 1].
inline Point position(const SurfaceEdge& edge, double s) {
  if (s == 0) return edge.x[0];
  if (s == 1) return edge.x[1];
  return (1 - s) * (1 - 2 * s) * edge.x[0] + s * (2 * s - 1) * edge.x[1] + 4 * s * (1 - s) * edge.x[2];
}
inline Point derivative(const SurfaceEdge& edge, double s) {
  return (4 * s - 3) * edge.x[0] + (4 * s - 1) * edge.x[1] + 4 * (1 - 2 * s) * edge.x[2];
}
/// Outward unit normal.
inline Point normal(const SurfaceEdge& edge, double s) {
  const Point along = derivative(edge, s).normalized();
  return {along[1], -along[0]};
}

}  // namespace parison::contact
