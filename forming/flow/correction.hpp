#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "forming/flow/changed_nodes.hpp"
#include "forming/flow/saddle_system.hpp"

namespace parison::flow {

/// Solves with a kept factorisation for nodes that are held otherwise than there. Each such node costs one back-substitution per
/// coordinate, once, and a small dense system per solve (the Schur complement of the changed nodes).
class Corrector {
 public:
  explicit Corrector(const core::Mesh& mesh) : system_(mesh) {}

  /// What brings `from` to balance with nodes held as `held`: column 0 with the driven tools at their velocities, column 1 + k
  /// for each m/s of driven tool k. Factorises anew where too much has changed; empty when the matrix is singular.
  std::optional<Eigen::MatrixXd> correct(const Problem& problem, const CellMatrices& cells, const Held& held,
                                         const Eigen::VectorXd& load, const Iterate& from);
  /// Starts with other cells: the next correction factorises. `beside` is a load that is answered too; it may be empty.
  void start(Eigen::VectorXd beside);
  /// The cells are others now.
  void forget();
  /// What the load beside does with nodes held as in the last correction, but given no velocity.
  std::optional<Eigen::VectorXd> answer_beside(const Problem& problem, const Held& held) const;
  int factorisations = 0;  ///< so far

 private:
  /// Factorises with the nodes held as `held`.
  [[nodiscard]] bool renew_base(const core::Mesh& mesh, const CellMatrices& cells, const Held& held);
  /// The base's answers to the residual and to each driven tool, those of the `wanted` handles behind them, and the one to the
  /// load beside where that has none.
  Eigen::MatrixXd base_answers(const Rearrangement& what, const CellMatrices& cells, const std::vector<Change>& changed,
                               const std::vector<Handle*>& wanted) const;

  SaddleSystem system_;
  Handles handles_;
  std::vector<Index> held_batches_;  ///< of the base
  Eigen::VectorXd beside_, beside_answer_;  ///< the latter the base's, once it has been found
};

}  // namespace parison::flow
