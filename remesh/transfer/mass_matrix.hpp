#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// int N_i N_j dV cell by cell, of the quadratic functions of the nodes (order 2) or the linear ones of the vertices
/// (1).
class MassMatrix {
 public:
  MassMatrix(const core::Mesh& mesh, core::Geometry geometry, int order);

  Eigen::VectorXd multiply(const Eigen::VectorXd& x) const;

  /// Conjugate gradients from `start` down to round-off; scaled by the diagonal the condition number is about 5. Gives
  /// `start` back where a folded cell makes the matrix indefinite.
  Eigen::VectorXd solve(const Eigen::VectorXd& load, const Eigen::VectorXd& start) const;

 private:
  const core::Mesh& mesh_;
  int functions_;  ///< of a cell
  std::vector<std::array<double, 36>> cells_;
  Eigen::VectorXd diagonal_;
};

}  // namespace parison::remesh
