#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/outline.hpp"

namespace parison::remesh {

/// Triangles with straight edges, counterclockwise. The outline's vertices come first, then the inner ones.
struct Triangulation {
  std::vector<core::Point> vertices;                  ///< m
  std::vector<std::array<core::Index, 3>> triangles;  ///< vertex numbers
  std::string reason;                                 ///< why meshing failed, a sentence; empty on success
};
/// Triangles of the size field inside an outline whose edges are kept, by the frontal Delaunay method (S. Rebay, J.
/// Comput. Phys. 106 (1993) 125-138) in gmsh (C. Geuzaine, J.-F. Remacle, Int. J. Numer. Meth. Engng 79 (2009)
/// 1309-1331).
Triangulation triangulate(const Outline& outline, const SizeField& size);

/// Two sweeps of smart Laplacian smoothing (L. A. Freitag 1997): each vertex, except the first `fixed` ones, at a
/// triangle of less than the quality `poor` is moved to the mean of its neighbours if the smallest quality of the
/// triangles around it rises by that.
void smooth_poor_triangles(std::size_t fixed, double poor, Triangulation& mesh);

}  // namespace parison::remesh
