#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Consistent mass matrix int N_i N_j dV, m3, or of a surface int N_i N_j dA, m2, stored element by element.
class MassMatrix {
 public:
  /// Of all cells.
  MassMatrix(const core::Mesh& mesh, core::Geometry geometry);
  /// Of edges of the boundary; the diagonal is 1 for nodes of none of them.
  MassMatrix(const core::Mesh& mesh, core::Geometry geometry, const std::vector<core::BoundaryEdge>& edges);

  Eigen::VectorXd multiply(const Eigen::VectorXd& x) const;

  /// Solves by conjugate gradients with Jacobi preconditioning from `start` to round-off. The preconditioned condition
  /// number is small whatever the mesh (A. J. Wathen, IMA J. Numer. Anal. 7 (1987) 449-457). Returns `start` where a
  /// folded cell makes the matrix indefinite. Where `given` is set, by unknown, the value of `start` stays and its
  /// equation is left out; empty: nowhere.
  Eigen::VectorXd solve(const Eigen::VectorXd& load, const Eigen::VectorXd& start,
                        const std::vector<bool>& given = {}) const;

 private:
  struct Element {
    std::array<core::Index, 6> nodes;
    std::array<double, 36> values;  ///< row by row, functions_ numbers each
  };
  void add(Element& element, const double* shape, double measure) const;
  void close(Element& element);

  int functions_;  ///< of an element
  std::vector<Element> elements_;
  Eigen::VectorXd diagonal_;
};

}  // namespace parison::remesh
