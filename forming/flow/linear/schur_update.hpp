#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <optional>

#include "forming/flow/balance.hpp"
#include "forming/flow/linear/saddle_system.hpp"

namespace parison::flow {

/// A coordinate of a node that is held otherwise than in a factorisation, the base: the base's answer to a unit force
/// (free there) or velocity (fixed there).
struct SchurColumn {
  Index node;
  int axis;
  bool fixed;
  Point direction;
  Eigen::VectorXd response;
  std::vector<std::pair<Index, double>> stiffness;  ///< K direction, where fixed
};
using SchurColumns = std::map<std::pair<Index, int>, SchurColumn>;

/// A node that is held otherwise than in the base.
struct NodeChange {
  enum class Kind { whole, normal, friction } kind;  ///< normal: what slides along a tool leaves it or lands there
  Index node;

  /// The coordinates that count: from the first to before the end.
  int first_axis() const { return kind == Kind::friction ? core::dim - 1 : 0; }
  int end_axis() const { return kind == Kind::normal ? 1 : core::dim; }
};
/// `schur_columns` are those that the base has answered already.
std::vector<NodeChange> changed_nodes(const Constraints& base, const Constraints& constraints,
                                      const SchurColumns& schur_columns);

/// The handle of a coordinate beside those that are there, its response not yet known. Where the base leaves the node
/// free the coordinates are those in which it is held now.
SchurColumn make_schur_column(const core::Mesh& mesh, const CellMatrices& cells, const Constraints& base,
                              const Constraints& constraints, const SchurColumns& schur_columns,
                              std::pair<Index, int> coordinate);

/// Two ways of holding the nodes, and what is out of balance.
struct ConstraintChange {
  const Problem& problem;
  const Constraints &base, &constraints;
  const Eigen::VectorXd& residual;
  const Iterate& from;
};

/// Adds to `columns`, the base's answers, what the changed nodes do (the Schur complement of these); false when it is
/// singular.
bool add_schur_correction(const ConstraintChange& update, const std::vector<NodeChange>& changed,
                          const SchurColumns& schur_columns, Eigen::MatrixXd& columns);

/// Solves with a kept factorisation for nodes that are held otherwise than there. Each such node costs one
/// back-substitution per coordinate, once, and a small dense system per solve (the Schur complement of the changed
/// nodes).
class Corrector {
 public:
  explicit Corrector(const core::Mesh& mesh) : system_(mesh) {}

  /// What brings `from` to balance with nodes held as `constraints`: column 0 with the driven tools at their
  /// velocities, column 1 + k for each m/s of driven tool k. Factorises anew where too much has changed; empty when the
  /// matrix is singular.
  std::optional<Eigen::MatrixXd> correct(const Problem& problem, const CellMatrices& cells,
                                         const Constraints& constraints, const Eigen::VectorXd& load,
                                         const Iterate& from);
  /// Starts with other cells: the next correction factorises. `additional_rhs` is a load that is answered too; it may
  /// be empty.
  void start(Eigen::VectorXd additional_rhs);
  /// The cells are others now.
  void forget();
  /// What the load beside does with nodes held as in the last correction, but given no velocity.
  std::optional<Eigen::VectorXd> additional_solution(const Problem& problem, const Constraints& constraints) const;
  int factorisations = 0;  ///< so far

 private:
  /// Factorises with the nodes held as `constraints`.
  [[nodiscard]] bool refactorise(const core::Mesh& mesh, const CellMatrices& cells, const Constraints& constraints);
  /// The base's answers to the residual and to each driven tool, those of the `wanted` handles behind them, and the one
  /// to the load beside where that has none.
  Eigen::MatrixXd base_solution(const ConstraintChange& update, const CellMatrices& cells,
                                const std::vector<NodeChange>& changed, const std::vector<SchurColumn*>& wanted) const;

  SaddleSystem system_;
  SchurColumns schur_columns_;
  std::vector<Index> constrained_batches_;                ///< of the base
  Eigen::VectorXd additional_rhs_, additional_solution_;  ///< the latter the base's, once it has been found
};

}  // namespace parison::flow
