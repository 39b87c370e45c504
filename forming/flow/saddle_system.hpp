#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/indefinite.hpp"
#include "forming/flow/constraints.hpp"
#include "forming/flow/element_matrix.hpp"

namespace parison::flow {

/// The saddle-point system of one mesh topology with its kept pattern and analysis, the cells' matrices, the load and the
/// nodes held by contact, symmetry and fixed pieces. Unknowns: two velocities per node, in its frame, then the pressures.
struct SaddleSystem {
  core::Assembly assembly;
  core::IndefiniteSolver linear;
  bool analysed = false;
  CellMatrices cells;
  Eigen::VectorXd load;
  std::vector<NodeFrame> frames;
  std::vector<Index> frame_of;  // per node, -1 where free

  explicit SaddleSystem(const core::Mesh& mesh);
  /// Unknowns of a cell.
  std::array<Index, cell_unknowns> unknowns(const core::Mesh& mesh, Index cell) const;
  /// Fills the matrix; the right-hand side has a further column for each driven tool, per m/s. `friction` is the drag per node, N.s/m.
  Eigen::MatrixXd assemble(const Problem& problem, const Eigen::VectorXd& friction);
  void add_constrained_cell(const std::array<Index, 6>& nodes, Index cell, Eigen::MatrixXd& rhs,
                            const std::array<Index, cell_unknowns>& where);
  /// Turns the velocities of held nodes from their frames into coordinates.
  void to_global_frame(Eigen::MatrixXd& solution) const;
  /// Frames of the nodes that the active candidates, symmetry and fixed pieces hold.
  void set_frames(const Problem& problem, const std::vector<bool>& active);
  /// Sees to it that no translation is left free, closing the contact that the glass would fall on; false when it would fall
  /// for ever. Radial motion of a ring is no translation.
  bool hold(const Problem& problem, std::vector<bool>& active);
  /// Force of the tools and planes on each node, N, two rows a node, a column for each of `solution`.
  Eigen::MatrixXd reactions(const Problem& problem, const Eigen::MatrixXd& solution) const;
};

}  // namespace parison::flow
