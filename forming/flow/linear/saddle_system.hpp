#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/indefinite.hpp"
#include "forming/flow/cells/cell_product.hpp"
#include "forming/flow/constraints.hpp"

namespace parison::flow {

/// The saddle-point system of one mesh topology: the cells' matrices, and a factorisation for one way of holding the
/// nodes in a pattern that is kept, with its analysis. Unknowns: two velocities per node, then the pressures at the
/// vertices.
class SaddleSystem {
 public:
  explicit SaddleSystem(const core::Mesh& mesh);

  Index size() const { return assembly_.matrix.size; }
  Index velocities() const { return size() - vertices_; }

  /// Factorises for nodes held as `base` with the cells' matrices; false when a pivot vanishes.
  [[nodiscard]] bool factorise(const core::Mesh& mesh, const CellMatrices& cells, const Constraints& base);
  bool factorised() const { return factorised_; }
  void forget() { factorised_ = false; }
  const Constraints& base() const { return base_; }
  /// Solves in coordinates for forces in coordinates; velocities that the base holds come out zero.
  Eigen::MatrixXd solve(Eigen::MatrixXd rhs) const;

 private:
  void add_constrained_cell(const std::array<Index, 6>& nodes, Index cell, CellMatrix local);
  void add_cell(const VectorizedArray* entries, Index cell);

  core::Assembly assembly_;
  core::IndefiniteSolver linear_;
  Index vertices_;
  std::vector<Index> diagonal_;  ///< places of the diagonal entries
  bool factorised_ = false;
  Constraints base_;
};

}  // namespace parison::flow
