#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/indefinite.hpp"
#include "forming/flow/cells/cell_product.hpp"
#include "forming/flow/contact/constraints.hpp"

namespace parison::flow {

/// The unknowns of a mesh (two velocities per node, then one pressure per vertex) in the order of their elimination:
/// both velocities of a node follow one another.
std::vector<Index> elimination_order(const core::Mesh& mesh);

/// The saddle-point matrix of one mesh topology with the constraints of one active set (the base) eliminated, and its
/// factorisation. Sparsity pattern and symbolic factorisation are kept. Unknowns: two velocities per node, then one
/// pressure per vertex.
class SaddleSystem {
 public:
  explicit SaddleSystem(const core::Mesh& mesh);

  Index size() const { return assembly_.matrix.size; }
  Index velocities() const { return size() - vertices_; }

  /// Assembles the cell matrices in the local bases of the constraints `base` and factorises; false where a pivot
  /// vanishes.
  [[nodiscard]] bool factorise(const core::Mesh& mesh, const CellMatrices& cells, const Constraints& base);
  bool factorised() const { return factorised_; }
  void forget() { factorised_ = false; }
  const Constraints& base() const { return base_; }
  /// Solves for right-hand sides in Cartesian coordinates, one per column; velocities that the base fixes come out
  /// zero.
  Eigen::MatrixXd solve(Eigen::MatrixXd rhs) const;

 private:
  void add_constrained_cell(const std::array<Index, 6>& nodes, Index cell, CellMatrix local);
  void add_cell(const VectorizedArray* entries, Index cell);

  core::Assembly assembly_;
  core::IndefiniteSolver linear_;
  Index vertices_;
  std::vector<Index> diagonal_;  ///< indices of the diagonal entries among the matrix's values
  bool factorised_ = false;
  Constraints base_;
};

}  // namespace parison::flow
