#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/solid/hex_mesh.hpp"

namespace parison::core {

/// Quadrature rule of a reference cell with the shape functions at its points.
struct CellTable {
  Eigen::MatrixXd shape;       ///< points x nodes
  Eigen::MatrixXd derivative;  ///< 3 points x nodes: row 3 q + d is the derivative at point q in direction d
  Eigen::VectorXd weight;      ///< by point; their sum is the volume of the reference cell

  Index nodes() const { return static_cast<Index>(shape.cols()); }
  Index points() const { return static_cast<Index>(shape.rows()); }
};
/// 27 nodes of HexMesh; 3 x 3 x 3 Gauss points, point a + 3 b + 9 c the one at (a, b, c) along the cube.
const CellTable& hexahedron_table();
/// 18 nodes of PrismMesh; the 6 points of triangle_rule(4) at 3 Gauss points.
const CellTable& prism_table();

/// Cells of either kind: cell c has the nodes first[c * table->nodes()] and following.
struct CellList {
  const CellTable* table;
  const Index* first;
  Index count;

  const Index* cell(Index c) const { return first + static_cast<std::size_t>(c) * table->nodes(); }
  Index point_count() const { return count * table->points(); }
};
template <typename Mesh>
CellList cell_list(const Mesh& mesh, const CellTable& table) {
  return {&table, mesh.cells.empty() ? nullptr : mesh.cells.front().data(), mesh.cell_count()};
}

/// What integrals of gradients need at each point of each cell, column c * points + q.
struct CellMetric {
  Eigen::VectorXd volume;  ///< weight times Jacobian, m3; not positive where the cell is inverted
  /// volume J^-1 J^-T: xx, xy, xz, yy, yz, zz, m; zero where the cell is inverted.
  Eigen::Matrix<double, 6, Eigen::Dynamic> gradient;
};
CellMetric cell_metric(const std::vector<Vector3>& nodes, const CellList& cells);
/// The volumes alone.
Eigen::VectorXd point_volumes(const std::vector<Vector3>& nodes, const CellList& cells);

}  // namespace parison::core
