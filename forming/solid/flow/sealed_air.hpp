#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "forming/solid/flow/flow_matrix.hpp"

namespace parison::flow {

/// What a step leaves of a pocket of air.
struct AirPocketEnd {
  double volume;   ///< m3
  double outflow;  ///< of pressure times volume through the vent, J
};

/// The pressures of sealed air in a step, by the volumes that the velocities of the glass leave it.
class SealedAir {
 public:
  /// For a step from the problem's state with the balance of forces at `middle`. The problem has air.
  SealedAir(const SolidProblem& problem, const HexMesh& middle);

  /// Sets on which points the air presses, those that do not touch, by index into SolidGlass::contact. `matrix` has its
  /// factor.
  void expose(const std::vector<bool>& touches, const FlowMatrix& matrix);
  /// Of voids that open, N, three for each node.
  const Eigen::VectorXd& suction() const { return suction_; }
  /// The velocity that is in balance with the air, from the one without it, m/s.
  Eigen::VectorXd balanced(const Eigen::VectorXd& without);
  /// The pockets at the end of a step with a velocity, m/s.
  std::vector<AirPocketEnd> ends(const Eigen::VectorXd& velocity) const;

 private:
  /// The load of 1 Pa on a point of a face, N.
  struct Load {
    std::size_t point;
    Index behind;
    std::array<Index, 9> nodes;
    Eigen::Matrix<double, 3, 9> force;
  };
  Eigen::VectorXd volume_rates(const Eigen::VectorXd& velocity) const;

  const TrappedAir* air_;
  std::vector<Load> loads_;
  Eigen::MatrixXd unit_, sweep_, response_;  ///< three rows for each node, a column for each pocket: N/Pa, m2, m/s/Pa
  Eigen::VectorXd by_tools_;                 ///< rates of volume by the motion of tools, m3/s
  Eigen::VectorXd suction_, pressure_;       ///< N; gauge, Pa
};

}  // namespace parison::flow
