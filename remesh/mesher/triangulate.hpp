#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/outline.hpp"

namespace parison::remesh {

/// Straight triangles, counterclockwise; the outline's vertices come first, then the inner ones.
struct Triangulation {
  std::vector<core::Point> vertices;
  std::vector<std::array<core::Index, 3>> triangles;
  std::string reason;  ///< empty when meshing went well
};
Triangulation triangulate(const Outline& outline, const SizeField& size);

/// Moves corners of triangles poorer than `poor`, but for the first `fixed`, to the middle of their neighbours where
/// that betters the worst triangle round them.
void smooth_poor_triangles(std::size_t fixed, double poor, Triangulation& mesh);

}  // namespace parison::remesh
