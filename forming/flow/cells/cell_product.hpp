#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/element_matrix.hpp"

namespace parison::flow {

/// Unknowns of a cell: two velocities per node of the mesh, then the pressures at its vertices.
std::array<Index, cell_unknowns> unknowns_of(const core::Mesh& mesh, Index cell);

/// The cells' forces on the unknowns, K x, a column for each of x.
Eigen::MatrixXd product(const core::Mesh& mesh, const CellMatrices& cells, const Eigen::MatrixXd& x);

/// The same over the cells of the listed batches alone.
Eigen::MatrixXd product(const core::Mesh& mesh, const CellMatrices& cells, const Eigen::MatrixXd& x,
                        const std::vector<Index>& batches);

/// Column 0: K x; column 1: the cells' |K| |x|, the products that make it up without sign.
Eigen::MatrixXd product_and_size(const core::Mesh& mesh, const CellMatrices& cells, const Eigen::VectorXd& x);

/// The cells' loads on the unknowns.
Eigen::VectorXd cell_loads(const core::Mesh& mesh, const CellMatrices& cells);

}  // namespace parison::flow
