#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/indefinite.hpp"
#include "forming/flow/constraints.hpp"
#include "forming/flow/element_matrix.hpp"

namespace parison::flow {

/// The saddle-point system of one mesh topology: the cells' matrices, and a factorisation for one way of holding the nodes in
/// a pattern that is kept, with its analysis. Unknowns: two velocities per node, then the pressures at the vertices.
class SaddleSystem {
 public:
  explicit SaddleSystem(const core::Mesh& mesh);

  Index size() const { return assembly_.matrix.size; }
  Index velocities() const { return size() - vertices_; }

  /// Factorises for nodes held as `base` with the cells' matrices; false when a pivot vanishes.
  [[nodiscard]] bool factorise(const core::Mesh& mesh, const CellMatrices& cells, const Held& base);
  bool factorised() const { return factorised_; }
  void forget() { factorised_ = false; }
  const Held& base() const { return base_; }
  /// Solves in coordinates for forces in coordinates; velocities that the base holds come out zero.
  Eigen::MatrixXd solve(Eigen::MatrixXd rhs) const;

 private:
  void add_held_cell(const std::array<Index, 6>& nodes, Index cell, const double* matrix);

  core::Assembly assembly_;
  core::IndefiniteSolver linear_;
  Index vertices_;
  bool analysed_ = false, factorised_ = false;
  Held base_;
};

/// The cells' forces on the unknowns, K x, a column for each of x; over the listed cells, or over all.
Eigen::MatrixXd product(const core::Mesh& mesh, const CellMatrices& cells, const Eigen::MatrixXd& x,
                        const std::vector<Index>* listed = nullptr);

/// Unknowns of a cell.
std::array<Index, cell_unknowns> unknowns_of(const core::Mesh& mesh, Index cell);

/// One cell's forces on its unknowns.
Eigen::Matrix<double, cell_unknowns, 1> cell_product(const double* matrix, const std::array<Index, cell_unknowns>& where,
                                                     Eigen::Ref<const Eigen::VectorXd> x);

}  // namespace parison::flow
