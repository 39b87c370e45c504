// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/contact/contact_forces.hpp"

#include <Eigen/LU>
#include <algorithm>

namespace parison::flow {

using core::dim;

ContactForces contact_forces(const Problem& problem, const std::vector<NodeConstraint>& constraints,
                             const Eigen::VectorXd& reaction) {
  const auto count = static_cast<Index>(problem.candidates.size());
  ContactForces forces{Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count)};
  const Point axis = core::axis_direction();
  for (const auto& constraint : constraints) {
    const Point total = node_velocity(reaction, constraint.node);
    const auto& equalities = constraint.equalities;
    if (equalities.size() == 1) {
      if (equalities[0].candidate < 0) continue;
      forces.normal[equalities[0].candidate] = total.dot(equalities[0].normal);
      forces.axial[equalities[0].candidate] = total.dot(axis);
      forces.sideways[equalities[0].candidate] = total.dot(perpendicular(equalities[0].normal));
      continue;
    }
    core::Tensor normals;
    for (int i = 0; i < dim; ++i) normals.col(i) = equalities[i].normal;
    const Point parts = normals.inverse() * total;
    for (int i = 0; i < dim; ++i) {
      if (equalities[i].candidate < 0) continue;
      forces.normal[equalities[i].candidate] = parts[i];
      forces.axial[equalities[i].candidate] = parts[i] * equalities[i].normal.dot(axis);
    }
  }
  return forces;
}

namespace {

/// Sum of the active candidates' values at each node.
Eigen::VectorXd sum_at_nodes(const Problem& problem, const std::vector<bool>& active,
                             const Eigen::VectorXd& per_candidate) {
  Eigen::VectorXd nodal = Eigen::VectorXd::Zero(problem.mesh->node_count());
  for (std::size_t i = 0; i < problem.candidates.size(); ++i)
    if (active[i]) nodal[problem.candidates[i].node] += per_candidate[i];
  return nodal;
}

}  // namespace

Eigen::VectorXd distribute_mid_sides(const core::Mesh& mesh, const Eigen::VectorXd& nodal) {
  Eigen::VectorXd shared = nodal;
  for (const auto& edge : mesh.boundary_edges())
    for (int end = 0; end < 2; ++end) shared[edge.nodes[end]] += 0.5 * nodal[edge.nodes[2]];
  return shared;
}

std::vector<bool> nodes_in_contact(const Problem& problem, const std::vector<bool>& active) {
  std::vector<bool> in_contact(problem.mesh->nodes.size(), false);
  for (std::size_t i = 0; i < active.size(); ++i)
    if (active[i]) in_contact[problem.candidates[i].node] = true;
  return in_contact;
}

Eigen::VectorXd lumped_forces(const Problem& problem, const std::vector<bool>& active,
                              const Eigen::VectorXd& normal_force) {
  return distribute_mid_sides(*problem.mesh, sum_at_nodes(problem, active, normal_force));
}

Eigen::VectorXd contact_pressure(const Problem& problem, const std::vector<bool>& active,
                                 const Eigen::VectorXd& normal_force, const Eigen::VectorXd& area) {
  const auto& mesh = *problem.mesh;
  const auto in_contact = nodes_in_contact(problem, active);
  const Eigen::VectorXd force = lumped_forces(problem, active, normal_force),
                        shared_area = distribute_mid_sides(mesh, area);
  Eigen::VectorXd pressure = Eigen::VectorXd::Zero(mesh.node_count());
  for (Index n = 0; n < mesh.vertex_count(); ++n)
    if (in_contact[n] && shared_area[n] > 0) pressure[n] = std::max(0.0, force[n] / shared_area[n]);
  for (const auto& edge : mesh.boundary_edges())
    if (in_contact[edge.nodes[2]]) pressure[edge.nodes[2]] = 0.5 * (pressure[edge.nodes[0]] + pressure[edge.nodes[1]]);
  return pressure;
}

}  // namespace parison::flow
