#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Quality of the cells of a mesh: the inverse condition number of the map from the equilateral triangle, in the
/// Frobenius norm and with the sign of the Jacobian (P. Knupp, SIAM J. Sci. Comput. 23 (2001) 193-218; SICN in gmsh):
/// sqrt 3 (u x v) / (u.u + v.v - u.v) with the columns u, v of the Jacobian. 1 is equilateral, 0 degenerate, negative
/// inverted.
struct Quality {
  double min, median, mean;
  core::Index min_quality_cell;
};
Quality quality(const core::Mesh& mesh);
/// The smallest quality of all cells, cheaper than all figures.
double min_quality(const core::Mesh& mesh);

/// Smallest quality at the six nodes of a cell, which detects a cell folded by a curved edge.
double cell_quality(const core::Mesh& mesh, core::Index cell);

}  // namespace parison::remesh
