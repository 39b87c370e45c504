#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <optional>

#include "forming/flow/saddle_system.hpp"

namespace parison::flow {

/// Velocities, pressures and the velocities of the driven tools, with K x.
struct Iterate {
  Eigen::VectorXd x, force;
  Eigen::VectorXd driven;  ///< m/s, in the order of driven_tools
};

/// Load minus K x minus friction, N and m3/s; at held coordinates it contains the reaction.
Eigen::VectorXd unbalanced(const Problem& problem, const Held& held, const Eigen::VectorXd& load, const Iterate& iterate);

/// Computes K x anew and returns the largest unbalanced force against the cells' parts that make it up.
double imbalance(const Problem& problem, const CellMatrices& cells, const Held& held, const Eigen::VectorXd& load,
                 Iterate& iterate);

/// Solves with a kept factorisation for nodes that are held otherwise than there. Each such node costs one back-substitution per
/// coordinate, once, and a small dense system per solve (the Schur complement of the changed nodes).
class Corrector {
 public:
  explicit Corrector(const core::Mesh& mesh) : system_(mesh) {}

  /// What brings `from` to balance with nodes held as `held`: column 0 with the driven tools at their velocities, column 1 + k
  /// for each m/s of driven tool k. Factorises anew where too much has changed; empty when the matrix is singular.
  std::optional<Eigen::MatrixXd> correct(const Problem& problem, const CellMatrices& cells, const Held& held,
                                         const Eigen::VectorXd& load, const Iterate& from);
  /// The cells or the mesh are others now: the next correction factorises.
  void forget();
  int factorisations = 0;  ///< so far

 private:
  /// A coordinate of a node that is held otherwise: the base's answer to a unit force (free there) or velocity (fixed there).
  struct Handle {
    Index node;
    int axis;
    bool fixed;
    Point direction;
    Eigen::VectorXd response;
    std::vector<std::pair<Index, double>> stiffness;  ///< K direction, where fixed
  };
  struct Change {
    Index node;
    bool drag_only;
  };

  std::vector<Change> changes(const Held& held) const;
  Eigen::MatrixXd base_columns(const Problem& problem, const CellMatrices& cells, const Eigen::VectorXd& residual,
                               const Iterate& from, const std::vector<Change>& changed,
                               const std::vector<std::pair<Index, int>>& wanted);
  void add_handles(const Problem& problem, const CellMatrices& cells, const std::vector<std::pair<Index, int>>& wanted);
  bool add_changes(const Problem& problem, const Held& held, const Eigen::VectorXd& residual, const Iterate& from,
                   const std::vector<Change>& changed, Eigen::MatrixXd& columns) const;

  SaddleSystem system_;
  std::map<std::pair<Index, int>, Handle> handles_;
  std::vector<Index> held_cells_;  ///< those with a node that the base holds or a handle
};

}  // namespace parison::flow
