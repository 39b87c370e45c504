#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "remesh/surface/outline.hpp"

namespace parison::remesh {

/// Triangles with straight edges, counterclockwise. The outline's vertices come first, then the inner ones.
struct Triangulation {
  std::vector<core::Point> vertices;                  ///< m
  std::vector<std::array<core::Index, 3>> triangles;  ///< vertex numbers
  std::string reason;                                 ///< why meshing failed, a sentence; empty on success
};

/// Fills an outline with triangles whose edges have about the sizes of the field; all edges of the outline stay.
using Mesher = std::function<Triangulation(const Outline& outline, const SizeField& size)>;

/// The mesher of the program: gmsh's frontal-Delaunay algorithm.
Triangulation triangulate(const Outline& outline, const SizeField& size);

/// The same by another algorithm of gmsh, a value of its option Mesh.Algorithm.
Triangulation triangulate_by_gmsh(const Outline& outline, const SizeField& size, int algorithm);

/// Moves corners of triangles poorer than `poor`, but for the first `fixed`, to the middle of their neighbours where
/// that betters the worst triangle round them.
void smooth_poor_triangles(std::size_t fixed, double poor, Triangulation& mesh);

/// Moves the inner vertices beside the surface, the outline where `in_surface` of its boundary, towards it: the first
/// cells, in which a thermal skin lies, become thinner and the next ones thicker, without more of them. Not where
/// surface lies on both sides, nor where a triangle would become poorer than `poor`.
void thin_first_cells(const Outline& outline, const std::vector<bool>& in_surface, double poor, Triangulation& mesh);

}  // namespace parison::remesh
