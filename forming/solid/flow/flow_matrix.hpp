#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "core/linear/cholesky.hpp"
#include "core/linear/sparse_matrix.hpp"
#include "forming/solid/flow/cell_matrices.hpp"
#include "forming/solid/flow/numbering.hpp"

namespace parison::flow {

/// The flow's matrix with the pressures eliminated by an augmented Lagrangian (M. Fortin, R. Glowinski, Augmented
/// Lagrangian Methods, 1983, chapter 1): they belong to single cells, A + gamma B' M^-1 B is positive definite, and
/// p += gamma M^-1 (s - B v) after each solution converges by about 1/gamma. M holds q q' over the mean viscosity of
/// the cell: with 1/eta itself, corrections are three times as many where the viscosity differs by 1e4 in a cell.
class FlowMatrix {
 public:
  /// Analyses the pattern; it serves as long as cells and conditions stay.
  FlowMatrix(const HexMesh& mesh, const std::vector<SymmetryPlane>& planes, const std::vector<Index>& fixed);

  /// Computes the cells of `glass` with its nodes at `mesh`, and a velocity that is expected, three for each node, m/s;
  /// what contact added is gone.
  void assemble(const SolidProblem& problem, const HexMesh& mesh, const Eigen::VectorXd& temperature,
                const Eigen::VectorXd& velocity);
  /// Adds a matrix between the velocities of a cell, Pa.s.m; the lower triangle is read.
  void add(Index cell, const HexMatrix& matrix);
  /// Throws core::RunError where the matrix is not positive definite.
  void factorise();
  /// Velocities, m/s, three for each node, that balance `force`, N, likewise, with pressures, Pa, four for each cell,
  /// and integrals of pressure functions times div v, m3/s, likewise.
  Eigen::VectorXd solve(const Eigen::VectorXd& force, const Eigen::VectorXd& pressure,
                        const Eigen::VectorXd& expansion) const;
  /// Integrals of pressure functions times div v, m3/s.
  Eigen::VectorXd divergence(const Eigen::VectorXd& velocity) const;
  /// Pressures after a solution with `pressure`.
  Eigen::VectorXd corrected_pressure(const Eigen::VectorXd& velocity, const Eigen::VectorXd& pressure,
                                     const Eigen::VectorXd& expansion) const;
  /// Of glass that remembers its stress: forces of what is left of it, N, three for each node, and integrals of
  /// pressure functions times its expansion rate, m3/s, four for each cell.
  const Eigen::VectorXd& memory_force() const { return memory_force_; }
  const Eigen::VectorXd& memory_expansion() const { return memory_expansion_; }
  /// Forces of weight, N, for an acceleration along the axis, m/s2, and a mass for each cell, kg.
  Eigen::VectorXd weight(double gravity, const Eigen::VectorXd& cell_mass) const;
  /// Integral of each pressure function over each cell, m3.
  const Eigen::Vector4d& moment(Index cell) const { return cells_[cell].moment; }
  double mean_viscosity(Index cell) const { return cells_[cell].mean_viscosity; }
  /// Floating-point operations of a factorisation.
  double operations() const { return factor_.operations(); }

 private:
  struct Cell {
    CellDivergence divergence;
    Eigen::Matrix4d penalty;  ///< gamma M^-1, or bulk modulus times the step over int q q' dV
    Eigen::Vector4d moment;
    core::HexShape share;
    double mean_viscosity;
  };
  struct Place {
    std::vector<int> local;                   ///< of the cell's unknowns in its 81 directions
    std::vector<std::array<int, 2>> repeats;  ///< of them two that are the same unknown, on the axis of a wedge
    std::vector<int> turned;                  ///< nodes with a frame of their own
  };
  CellVector of_cell(const Eigen::VectorXd& space, Index cell) const;
  void turn(Index cell, HexMatrix& matrix) const;
  void set_given(const SolidProblem& problem);

  Numbering numbering_;
  std::vector<std::array<Index, HexMesh::nodes_per_cell>> nodes_;  ///< of each cell
  std::vector<Place> places_;
  core::Assembly assembly_;
  core::Cholesky factor_;
  std::vector<Cell> cells_;
  Eigen::VectorXd memory_force_, memory_expansion_;
  Eigen::VectorXd given_;        ///< velocities that are given, 0 elsewhere, three for each node, m/s
  Eigen::VectorXd given_force_;  ///< that they make, N, likewise
  bool moves_given_ = false;     ///< whether one is not zero
};

}  // namespace parison::flow
