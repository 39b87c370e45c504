#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>
#include <vector>

#include "forming/flow/problem.hpp"

namespace parison::flow {

/// One equality on a node's velocity: normal.v = value + sum over driven tools of coefficient x V.
struct NodeEquality {
  Point normal;
  double value = 0;
  Index tool = -1;       ///< Problem::tools index, -1 for symmetry planes and fixed boundaries
  Index candidate = -1;  ///< Problem::candidates index, -1 likewise
};

/// The equalities of one node, kept in place: at most dim, independent.
struct NodeEqualities {
  std::array<NodeEquality, core::dim> list;
  std::size_t count = 0;

  void push_back(const NodeEquality& equality) { list[count++] = equality; }
  std::size_t size() const { return count; }
  const NodeEquality& operator[](std::size_t i) const { return list[i]; }
  const NodeEquality* begin() const { return list.data(); }
  const NodeEquality* end() const { return list.data() + count; }
};

/// Tools driven by force at a time, at the most.
inline constexpr int max_driven_tools = 4;
/// Coordinates of a velocity: column 0 constant, column 1 + k per m/s of driven tool k.
using GivenVelocity =
    Eigen::Matrix<double, core::dim, Eigen::Dynamic, Eigen::ColMajor, core::dim, 1 + max_driven_tools>;

/// A node with equalities, in the frame of its columns: v = frame u, u[i] given where fixed[i].
struct NodeConstraint {
  Index node;
  core::Tensor basis = core::Tensor::Identity();
  std::array<bool, core::dim> fixed{};
  GivenVelocity given;
  NodeEqualities equalities;
  Index friction_tool = -1;  ///< Navier friction acts along the last column of the frame
};

/// How the nodes are held with one set of closed contacts.
struct Constraints {
  std::vector<NodeConstraint> nodes;
  std::vector<Index> index_of;  ///< per node, -1 where free
  /// Per node, along the last column of the frame where friction acts: friction = drag x slip + pull, N.s/m and N.
  Eigen::VectorXd tangential_stiffness, tangential_load;

  const NodeConstraint* find(Index node) const { return index_of[node] < 0 ? nullptr : &nodes[index_of[node]]; }
};

/// A direction along a surface: its normal turned left.
inline Point perpendicular(const Point& normal) {
  return {-normal[1], normal[0]};
}

/// Whether a contact holds the glass along the tool's surface.
bool sticks(const Problem& problem, const ContactCandidate& candidate);

/// Tools whose velocity is an unknown, as indices into Problem::tools.
std::vector<Index> driven_tools(const Problem& problem);

/// The nodes held by symmetry, fixed boundaries and the active candidates; no friction yet.
Constraints make_constraints(const Problem& problem, const std::vector<bool>& active);

/// Sees to it that no translation is left free, closing the contact that the glass would fall on under `load`; false
/// when it would fall for ever. Radial motion of a ring is no translation.
bool support(const Problem& problem, const Eigen::VectorXd& load, std::vector<bool>& active, Constraints& constraints);

/// A rigid motion of the glass that nothing can hold, as a sentence; empty where there is none. Symmetry planes, fixed
/// boundaries and every candidate count, closed or not: tools that stick or rub hold sideways as well.
std::string free_motion(const Problem& problem);

}  // namespace parison::flow
