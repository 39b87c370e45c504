#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>
#include <vector>

#include "forming/flow/problem.hpp"

namespace parison::flow {

/// An equality constraint of a node's velocity v: normal.v = value + normal.axis V, with the velocity V of the tool
/// where that is driven by force.
struct NodeEquality {
  Point normal;          ///< unit
  double value = 0;      ///< m/s
  Index tool = -1;       ///< Problem::tools index, -1 for symmetry planes and fixed boundaries
  Index candidate = -1;  ///< Problem::candidates index, -1 likewise
};

/// The equality constraints of one node: at most dim, linearly independent.
struct NodeEqualities {
  std::array<NodeEquality, core::dim> list;
  std::size_t count = 0;

  void push_back(const NodeEquality& equality) { list[count++] = equality; }
  std::size_t size() const { return count; }
  const NodeEquality& operator[](std::size_t i) const { return list[i]; }
  const NodeEquality* begin() const { return list.data(); }
  const NodeEquality* end() const { return list.data() + count; }
};

/// Largest number of tools driven by force at a time.
inline constexpr int max_driven_tools = 4;
/// Prescribed components of a nodal velocity, m/s: column 0 constant, column 1 + k per m/s of driven tool k.
using GivenVelocity =
    Eigen::Matrix<double, core::dim, Eigen::Dynamic, Eigen::ColMajor, core::dim, 1 + max_driven_tools>;

/// A constrained node, in its local basis: v = basis u, with u[i] prescribed where fixed[i].
struct NodeConstraint {
  Index node;
  core::Tensor basis = core::Tensor::Identity();  ///< orthonormal columns
  std::array<bool, core::dim> fixed{};
  GivenVelocity given;  ///< the prescribed u
  NodeEqualities equalities;
  Index friction_tool = -1;  ///< tool with friction along the last column of the basis, -1 without
  double give = 0;  ///< of a node that gives way beside a corner: shear stress over viscosity and slip, 1/m; 0 else
};

/// The constrained nodes with one active set.
struct Constraints {
  std::vector<NodeConstraint> nodes;
  std::vector<Index> index_of;  ///< index of each node in `nodes`, -1 where it is free
  /// Friction force of each node with a friction tool, linear in the slip: stiffness x slip + load, N.s/m and N.
  Eigen::VectorXd tangential_stiffness, tangential_load;

  /// The constraint of a node, null where it is free.
  const NodeConstraint* find(Index node) const { return index_of[node] < 0 ? nullptr : &nodes[index_of[node]]; }
};

/// The tangent of a surface: its normal turned left.
inline Point perpendicular(const Point& normal) {
  return {-normal[1], normal[0]};
}

/// Whether an active contact prevents slip along the tool, but beside a corner (wedged_corner.hpp). A tool that holds
/// glass by its form drags it instead (grip.hpp).
bool sticks(const Problem& problem, const ContactCandidate& candidate);

/// Tools whose velocity is an unknown, as indices into Problem::tools.
std::vector<Index> driven_tools(const Problem& problem);

/// Constraints of symmetry planes, fixed boundaries and the active candidates, without friction (`add_friction`).
Constraints make_constraints(const Problem& problem, const std::vector<bool>& active);

/// Prevents rigid translations: where no constraint resists one, the contact on which the glass would fall under `load`
/// (N, two per node) is added to the active set and the constraints are rebuilt. False where there is no such contact.
/// An axisymmetric body can only translate along its axis.
bool support(const Problem& problem, const Eigen::VectorXd& load, std::vector<bool>& active, Constraints& constraints);

/// A sentence that names a rigid-body motion of the glass that is not constrained; empty where there is none.
/// Symmetry planes, fixed boundaries and all candidates count, active or not; tools with friction resist sideways
/// motion as well.
std::string free_motion(const Problem& problem);

}  // namespace parison::flow
