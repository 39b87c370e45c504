#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <optional>

#include "forming/flow/balance.hpp"
#include "forming/flow/linear/saddle_system.hpp"

namespace parison::flow {

/// A nodal coordinate whose constraint differs from that of the factorised matrix (the base), with the solution of the
/// base for a unit force (where the base leaves it free) or a unit velocity (where the base fixes it) along it.
struct SchurColumn {
  Index node;
  int axis;                                         ///< column of the node's local basis
  bool fixed;                                       ///< in the base
  Point direction;                                  ///< unit
  Eigen::VectorXd response;                         ///< one entry per unknown
  std::vector<std::pair<Index, double>> stiffness;  ///< nonzero entries of K direction, where fixed
};
/// By node and axis.
using SchurColumns = std::map<std::pair<Index, int>, SchurColumn>;

/// A node whose constraint differs from that of the base.
struct NodeChange {
  /// whole: all coordinates; normal: frictionless contact opened or closed; friction: the tangential stiffness alone.
  enum class Kind { whole, normal, friction } kind;
  Index node;

  /// The coordinates concerned: from the first to before the end.
  int first_axis() const { return kind == Kind::friction ? core::dim - 1 : 0; }
  int end_axis() const { return kind == Kind::normal ? 1 : core::dim; }
};
/// The nodes whose constraints differ; `schur_columns` are those with a known response.
std::vector<NodeChange> changed_nodes(const Constraints& base, const Constraints& constraints,
                                      const SchurColumns& schur_columns);

/// The column of one more coordinate, its response not yet computed. Where the base leaves the node free its
/// coordinates are those of the present constraint.
SchurColumn make_schur_column(const core::Mesh& mesh, const CellMatrices& cells, const Constraints& base,
                              const Constraints& constraints, const SchurColumns& schur_columns,
                              std::pair<Index, int> coordinate);

/// From the constraints of the base to the present ones, with the residual of the iterate `from`.
struct ConstraintChange {
  const Problem& problem;
  const Constraints &base, &constraints;
  const Eigen::VectorXd& residual;
  const Iterate& from;
};

/// Corrects `columns`, solutions with the constraints of the base, for the changed nodes: solves the dense Schur
/// complement for the forces at coordinates that the base leaves free and the velocities at those that it fixes. False
/// where it is singular.
bool add_schur_correction(const ConstraintChange& update, const std::vector<NodeChange>& changed,
                          const SchurColumns& schur_columns, Eigen::MatrixXd& columns);

/// Solves the linear equations of consecutive active sets with one factorisation, by the Schur-complement method of
/// active sets (P. Gill, W. Murray, M. Saunders, M. Wright, 1990, in Reliable Numerical Computation, Oxford, 113-138):
/// each coordinate whose constraint has changed since the factorisation costs one back-substitution, once, and one row
/// of a small dense system in every solve.
class Corrector {
 public:
  explicit Corrector(const core::Mesh& mesh) : system_(mesh) {}

  /// The correction that brings `from` to equilibrium with the given constraints, a row per unknown: column 0 with the
  /// driven tools at their velocities, column 1 + k for each m/s of driven tool k. Refactorises where too much has
  /// changed; nothing where the matrix is singular.
  std::optional<Eigen::MatrixXd> correct(const Problem& problem, const CellMatrices& cells,
                                         const Constraints& constraints, const Eigen::VectorXd& load,
                                         const Iterate& from);
  /// Starts another problem: the next correction factorises. `additional_rhs` is a further right-hand side to solve
  /// for, one entry per unknown or empty.
  void start(Eigen::VectorXd additional_rhs);
  /// Discards the factorisation, because the cell matrices have changed.
  void forget();
  /// Solution for the additional right-hand side with the constraints of the last correction, all prescribed velocities
  /// zero.
  std::optional<Eigen::VectorXd> additional_solution(const Problem& problem, const Constraints& constraints) const;
  /// Solution for a force on the nodes (one entry per unknown) with the constraints of the last correction, all
  /// prescribed velocities zero.
  std::optional<Eigen::VectorXd> response_to(const Problem& problem, const Constraints& constraints,
                                             const Eigen::VectorXd& force) const;
  int factorisations = 0;  ///< since `start`

 private:
  /// A solution of the base for `rhs`, corrected for the constraints of the last correction.
  std::optional<Eigen::VectorXd> at_rest(const Problem& problem, const Constraints& constraints,
                                         const Eigen::VectorXd& rhs, const Eigen::VectorXd& base_solution) const;
  /// Lists the changed nodes and their coordinates without a known column; false, and the lists empty, where it is
  /// cheaper to refactorise.
  [[nodiscard]] bool select_columns(const Constraints& constraints, std::vector<NodeChange>& changed,
                                    std::vector<std::pair<Index, int>>& missing) const;
  /// Factorises with the given constraints as the base; false where the matrix is singular.
  [[nodiscard]] bool refactorise(const core::Mesh& mesh, const CellMatrices& cells, const Constraints& constraints);
  /// Solutions of the base, a row per unknown: for the residual, for each m/s of each driven tool, for the `wanted`
  /// columns, and last for the additional right-hand side unless that is known.
  Eigen::MatrixXd base_solutions(const ConstraintChange& update, const CellMatrices& cells,
                                 const std::vector<NodeChange>& changed, const std::vector<SchurColumn*>& wanted) const;

  SaddleSystem system_;
  SchurColumns schur_columns_;
  std::vector<Index> constrained_batches_;                ///< of the base
  Eigen::VectorXd additional_rhs_, additional_solution_;  ///< the solution with the constraints of the base, once known
};

}  // namespace parison::flow
