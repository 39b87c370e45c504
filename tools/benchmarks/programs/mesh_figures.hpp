#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>

#include "core/mesh/mesh.hpp"
#include "remesh/sizing/size_field.hpp"

namespace parison::bench {

/// How good a mesh is and how well it keeps the size field.
struct MeshFigures {
  double min, median;                  ///< quality, see remesh::Quality
  double min_angle = 180;              ///< between chords, degrees
  double size_mean = 0, size_max = 0;  ///< |log2(edge over size at its middle)| of the inner edges
  double max_jump = 1;                 ///< ratio of the areas of two neighbours
  std::uint64_t bits;                  ///< of nodes and cells
};
MeshFigures mesh_figures(const core::Mesh& mesh, const remesh::SizeField& size);

}  // namespace parison::bench
