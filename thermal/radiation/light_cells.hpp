#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "core/linear/sparse_matrix.hpp"
#include "thermal/cells/cell_batch.hpp"

namespace parison::thermal {

struct BodyView;

/// Numbers at the quadrature points of a body, batch after batch.
using Field = std::vector<PointValues>;

/// Volume of each quadrature point on the present mesh, m3; zero in the lanes that hold no cell of their own.
Field make_volumes(const BodyView& body, core::Geometry geometry);

/// Values at the points from those of the unknowns; `batches` points to the first of `count` batches.
Field at_points(const BatchIndices<6>* batches, std::size_t count, const double* unknowns);
/// The transpose: adds what acts at the points to the unknowns.
void add_from_points(const BatchIndices<6>* batches, const Field& values, double* unknowns);

/// Adds diffusion int grad N_i . grad N_j + absorption int N_i N_j of a body's cells to the matrix, whose cliques
/// begin with the cells. `relative` multiplies the absorption and divides the diffusion at each point; null: 1.
void assemble_group(const std::vector<CellBatch>& cells, const Field& volumes, const Field* relative,
                    core::Index cell_count, double diffusion, double absorption, core::Assembly& assembly);

}  // namespace parison::thermal
