#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>

#include "forming/flow/balance.hpp"

namespace parison::flow {

/// A coordinate of a node that is held otherwise than in a factorisation, the base: the base's answer to a unit force (free
/// there) or velocity (fixed there).
struct Handle {
  Index node;
  int axis;
  bool fixed;
  Point direction;
  Eigen::VectorXd response;
  std::vector<std::pair<Index, double>> stiffness;  ///< K direction, where fixed
};
using Handles = std::map<std::pair<Index, int>, Handle>;

/// A node that is held otherwise than in the base.
struct Change {
  enum class Kind { whole, normal, drag } kind;  ///< normal: what slides along a tool leaves it or lands there
  Index node;

  /// The coordinates that count: from the first to before the end.
  int first_axis() const { return kind == Kind::drag ? core::dim - 1 : 0; }
  int end_axis() const { return kind == Kind::normal ? 1 : core::dim; }
};
/// `handles` are those that the base has answered already.
std::vector<Change> changed_nodes(const Held& base, const Held& held, const Handles& handles);

/// The handle of a coordinate beside those that are there, its response not yet known. Where the base leaves the node free the
/// coordinates are those in which it is held now.
Handle make_handle(const core::Mesh& mesh, const CellMatrices& cells, const Held& base, const Held& held,
                   const Handles& handles, std::pair<Index, int> coordinate);

/// Two ways of holding the nodes, and what is out of balance.
struct Rearrangement {
  const Problem& problem;
  const Held &base, &held;
  const Eigen::VectorXd& residual;
  const Iterate& from;
};

/// Adds to `columns`, the base's answers, what the changed nodes do (the Schur complement of these); false when it is singular.
bool add_changes(const Rearrangement& what, const std::vector<Change>& changed, const Handles& handles,
                 Eigen::MatrixXd& columns);

}  // namespace parison::flow
