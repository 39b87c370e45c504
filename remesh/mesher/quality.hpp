#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Scaled inverse condition number of the cells: 1 equilateral, 0 degenerate, negative inverted.
struct Quality {
  double min, median, mean;
  core::Index min_quality_cell;
};
Quality quality(const core::Mesh& mesh);
/// The worst cell's alone.
double min_quality(const core::Mesh& mesh);

/// Smallest value at the six nodes of a cell, so that a curved edge that folds the cell shows.
double cell_quality(const core::Mesh& mesh, core::Index cell);

}  // namespace parison::remesh
