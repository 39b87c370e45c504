// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/contact/constraints.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/mesh/element.hpp"
#include "forming/flow/contact/grip.hpp"
#include "forming/flow/contact/wedged_corner.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// Two normals with a smaller sine of the angle between them count as parallel.
constexpr double parallel = 0.05;

/// The equality constraints of all nodes.
struct NodeEqualityMap {
  std::vector<Index> of_node;  ///< index of each node in `equalities`, -1 where it has none
  std::vector<NodeEqualities> equalities;

  /// Adds an equality to a node, unless it depends on those that the node has already.
  void add(Index node, const NodeEquality& equality) {
    if (of_node[node] < 0) {
      of_node[node] = static_cast<Index>(equalities.size());
      equalities.emplace_back();
    }
    auto& list = equalities[of_node[node]];
    if (list.size() >= dim) return;
    for (const auto& known : list)
      if (std::abs(known.normal[0] * equality.normal[1] - known.normal[1] * equality.normal[0]) < parallel) return;
    list.push_back(equality);
  }
};

/// Equalities of symmetry planes and fixed boundaries.
void add_boundary_equalities(const Problem& problem, NodeEqualityMap& nodes) {
  const auto& mesh = *problem.mesh;
  for (const auto& edge : mesh.boundary_edges()) {
    const auto& condition = problem.boundary_conditions[edge.boundary_id];
    if (condition.kind == BoundaryCondition::Kind::free) continue;
    const auto at = core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, {0.5, 1.0});
    for (const Index node : edge.nodes) {
      const bool fixed = condition.kind == BoundaryCondition::Kind::fixed;
      const Point velocity = fixed && condition.velocity ? condition.velocity(mesh.nodes[node]) : Point(Point::Zero());
      nodes.add(node, {at.normal, velocity.dot(at.normal)});
      if (fixed) nodes.add(node, {at.tangent, velocity.dot(at.tangent)});
    }
  }
}

/// The tangential constraint of a sticking contact. Before it lands within the step the node slides freely.
NodeEquality sticking(const Problem& problem, const ContactCandidate& candidate) {
  const Point tangent = perpendicular(candidate.normal);
  NodeEquality side{tangent, (1 - candidate.contact_fraction) * candidate.approach_velocity.dot(tangent),
                    candidate.tool, -1};
  const ToolMotion& tool = problem.tools[candidate.tool];
  if (!tool.force) side.value += tool.velocity * tangent.dot(core::axis_direction());
  return side;
}

/// Local basis and prescribed velocity of a node with the given equalities, `held` where a tool holds it by its form.
/// One equality: the basis is its normal and tangent; two: the basis is Cartesian and the whole velocity is prescribed.
NodeConstraint make_node_constraint(const Problem& problem, Index node, const NodeEqualities& equalities,
                                    const std::vector<Index>& driven, const std::vector<WedgedCorner>& corners) {
  NodeConstraint result;
  result.node = node;
  result.equalities = equalities;
  const Point axis = core::axis_direction();
  auto rows = equalities;
  if (rows.size() == 1) {
    result.basis.col(0) = rows[0].normal;
    result.basis.col(1) = perpendicular(rows[0].normal);
    const Index tool = rows[0].tool;
    if (tool >= 0 && sticks(problem, problem.candidates[rows[0].candidate])) {
      const double give = give_way(problem, node, tool, corners);
      if (std::isfinite(give)) {
        result.friction_tool = tool;
        result.give = give;
      } else {
        rows.push_back(sticking(problem, problem.candidates[rows[0].candidate]));
      }
    } else if (tool >= 0 && problem.tools[tool].friction.law == Friction::Law::navier) {
      result.friction_tool = tool;
    }
  }
  core::Tensor normals = core::Tensor::Identity();
  GivenVelocity values = GivenVelocity::Zero(dim, 1 + Index(driven.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    normals.row(i) = rows[i].normal.transpose();
    values(i, 0) = rows[i].value;
    const auto k = std::find(driven.begin(), driven.end(), rows[i].tool);
    if (k != driven.end()) values(i, 1 + (k - driven.begin())) = rows[i].normal.dot(axis);
    result.fixed[i] = true;
  }
  if (rows.size() == dim) {
    values = (normals.inverse() * values).eval();
    result.basis = core::Tensor::Identity();
  }
  result.given = values;
  return result;
}

}  // namespace

bool sticks(const Problem& problem, const ContactCandidate& candidate) {
  const auto law = problem.tools[candidate.tool].friction.law;
  return law == Friction::Law::stick || (law == Friction::Law::grip && !held_by_form(problem, candidate));
}

std::vector<Index> driven_tools(const Problem& problem) {
  std::vector<Index> driven;
  for (Index t = 0; t < static_cast<Index>(problem.tools.size()); ++t)
    if (problem.tools[t].force) driven.push_back(t);
  return driven;
}

Constraints make_constraints(const Problem& problem, const std::vector<bool>& active) {
  const auto driven = driven_tools(problem);
  NodeEqualityMap nodes{std::vector<Index>(problem.mesh->nodes.size(), -1), {}};
  add_boundary_equalities(problem, nodes);
  const Point axis = core::axis_direction();
  for (std::size_t i = 0; i < problem.candidates.size(); ++i) {
    if (!active[i]) continue;
    const auto& candidate = problem.candidates[i];
    const auto& tool = problem.tools[candidate.tool];
    NodeEquality equality{candidate.normal, candidate.rate, candidate.tool, Index(i)};
    if (!tool.force) equality.value += tool.velocity * candidate.normal.dot(axis);
    nodes.add(candidate.node, equality);
  }
  Constraints constraints;
  constraints.index_of.assign(nodes.of_node.size(), -1);
  constraints.nodes.reserve(nodes.equalities.size());
  std::vector<WedgedCorner> corners;
  for (Index node = 0; node < problem.mesh->node_count(); ++node)
    if (nodes.of_node[node] >= 0) add_wedged_corners(problem, node, nodes.equalities[nodes.of_node[node]], corners);
  constraints.tangential_stiffness = constraints.tangential_load = Eigen::VectorXd::Zero(problem.mesh->node_count());
  for (Index node = 0; node < problem.mesh->node_count(); ++node) {
    if (nodes.of_node[node] < 0) continue;
    constraints.index_of[node] = static_cast<Index>(constraints.nodes.size());
    constraints.nodes.push_back(
        make_node_constraint(problem, node, nodes.equalities[nodes.of_node[node]], driven, corners));
  }
  return constraints;
}

namespace {

/// Cosine between a normal and an axis from which a contact resists a translation along that axis.
constexpr double resisting = 1e-3;

/// Whether any constraint resists a translation of the glass along coordinate `axis`.
bool resists(const std::vector<NodeConstraint>& constraints, int axis) {
  return std::any_of(constraints.begin(), constraints.end(), [&](const NodeConstraint& constraint) {
    for (int a = 0; a < dim; ++a)
      if ((constraint.fixed[a] || (constraint.friction_tool >= 0 && a == dim - 1)) &&
          std::abs(constraint.basis(axis, a)) > resisting)
        return true;
    return false;
  });
}

/// Adds the candidate to the active set that glass under a force `load` along `axis` would meet first; false where
/// there is none. A face that lies nearly along the axis, as a steep taper, carries where there is no other.
bool activate_first_met(const Problem& problem, int axis, double load, std::vector<bool>& active) {
  constexpr double across = 0.1;
  int best = -1, steep = -1;
  const auto along_axis = [&](int i) {
    return problem.candidates[i].rate / std::abs(problem.candidates[i].normal[axis]);
  };
  for (int i = 0; i < static_cast<int>(active.size()); ++i) {
    const auto& candidate = problem.candidates[i];
    const double cosine = std::abs(candidate.normal[axis]);
    if (active[i] || candidate.normal[axis] * load >= 0 || cosine <= resisting) continue;
    if (cosine < across) {
      if (steep < 0 || along_axis(i) > along_axis(steep)) steep = i;
    } else if (best < 0 || candidate.rate > problem.candidates[best].rate) {
      best = i;
    }
  }
  if (best < 0) best = steep;
  if (best >= 0) active[best] = true;
  return best >= 0;
}

}  // namespace

bool support(const Problem& problem, const Eigen::VectorXd& load, std::vector<bool>& active, Constraints& constraints) {
  const bool rings = core::hoop(problem.geometry, Point::Ones()) != 0;
  if (std::any_of(problem.candidates.begin(), problem.candidates.end(),
                  [&](const auto& candidate) { return held_by_form(problem, candidate); }))
    return true;
  for (int axis = rings ? dim - 1 : 0; axis < dim; ++axis) {
    if (resists(constraints.nodes, axis)) continue;
    double force = 0;
    for (Index n = 0; n < problem.mesh->node_count(); ++n) force += load[dim * n + axis];
    if (!activate_first_met(problem, axis, force, active)) return false;
    constraints = make_constraints(problem, active);
  }
  return true;
}

namespace {

/// Eigenvalues of the constrained motions below this, relative, count as zero.
constexpr double zero_eigenvalue = 1e-8;

/// Rigid-body motions of a plane body: translations along both axes, and rotation about its centre scaled by its size.
constexpr int motions = dim + 1;
using Motion = Eigen::Matrix<double, motions, 1>;

/// Rigid-body motions of a body about its centre.
struct RigidBody {
  Point middle = Point::Zero();
  double size = 0;  ///< largest distance from the centre, m

  explicit RigidBody(const core::Mesh& mesh) {
    for (const auto& x : mesh.nodes) middle += x / double(mesh.nodes.size());
    for (const auto& x : mesh.nodes) size = std::max(size, (x - middle).norm());
  }
  /// Velocity component at x along a direction under each motion, m/s.
  Motion velocities(const Point& x, const Point& direction) const {
    const Point arm = (x - middle) / size;
    Motion row;
    row << direction, arm[0] * direction[1] - arm[1] * direction[0];
    return row;
  }
};

/// Sum over all possible constraints of the outer products of their velocity components: its null space are the free
/// motions.
Eigen::Matrix<double, motions, motions> constrained_motions(const Problem& problem) {
  const core::Mesh& mesh = *problem.mesh;
  const RigidBody body(mesh);
  Eigen::Matrix<double, motions, motions> sum = Eigen::Matrix<double, motions, motions>::Zero();
  const auto constrain = [&](Index node, const Point& direction) {
    const Motion row = body.velocities(mesh.nodes[node], direction);
    sum += row * row.transpose();
  };
  for (const auto& edge : mesh.boundary_edges()) {
    const auto kind = problem.boundary_conditions[edge.boundary_id].kind;
    if (kind == BoundaryCondition::Kind::free) continue;
    const auto at = core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, {0.5, 1.0});
    for (const Index node : edge.nodes) {
      constrain(node, at.normal);
      if (kind == BoundaryCondition::Kind::fixed) constrain(node, at.tangent);
    }
  }
  for (const auto& candidate : problem.candidates) {
    constrain(candidate.node, candidate.normal);
    if (problem.tools[candidate.tool].friction.law != Friction::Law::slip)
      constrain(candidate.node, perpendicular(candidate.normal));
  }
  return sum;
}

}  // namespace

std::string free_motion(const Problem& problem) {
  const auto sentence = [](const char* motion) {
    return std::string("the glass is not constrained: it is free to ") + motion +
           ", which no tool, symmetry plane or fixed boundary prevents";
  };
  const auto constrained = constrained_motions(problem);
  if (core::hoop(problem.geometry, Point::Ones()) != 0)  // an axisymmetric body only moves along its axis
    return constrained(dim - 1, dim - 1) > zero_eigenvalue ? "" : sentence("move along the axis");
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, motions, motions>> modes(constrained);
  if (modes.eigenvalues()[0] > zero_eigenvalue * std::max(1.0, modes.eigenvalues()[motions - 1])) return "";
  Index axis = 0;
  modes.eigenvectors().col(0).cwiseAbs().maxCoeff(&axis);
  return sentence(axis == dim ? "turn" : axis == dim - 1 ? "move along the axis" : "move sideways");
}

}  // namespace parison::flow
