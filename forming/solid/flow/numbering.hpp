#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "forming/solid/flow/solid_problem.hpp"

namespace parison::flow {

/// The velocities that the balance of forces decides, in the order of their elimination. Each node has a frame of three
/// directions; those into planes of symmetry, and all of fixed nodes, are given.
class Numbering {
 public:
  Numbering(const HexMesh& mesh, const std::vector<SymmetryPlane>& planes, const std::vector<Index>& fixed);

  Index size() const { return size_; }
  /// Number of a node's direction; -1 where it is given.
  Index unknown(Index node, int direction) const { return unknown_[3 * node + direction]; }
  /// Directions of a node in its columns.
  const Eigen::Matrix3d& frame(Index node) const { return frames_[frame_of_[node]]; }
  /// Whether its directions are those of space.
  bool is_plain(Index node) const { return frame_of_[node] == 0; }

  /// Of a vector with three components in space for each node, and back, where given directions have nothing.
  Eigen::VectorXd to_unknowns(const Eigen::VectorXd& space) const;
  Eigen::VectorXd to_space(const Eigen::VectorXd& unknowns) const;

 private:
  void number(const HexMesh& mesh, const std::vector<std::array<bool, 3>>& given);

  Index size_ = 0;
  std::vector<Index> unknown_;
  std::vector<Eigen::Matrix3d> frames_;  ///< the first: of space
  std::vector<Index> frame_of_;
};

}  // namespace parison::flow
