// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/balance.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace parison::flow {

namespace {

/// Share of the largest resistance by which tools that press glass against each other alone are kept from drifting.
constexpr double min_resistance = 1e-12;

/// Velocities of the driven tools: force balance, or the speed limit where it would be passed.
/// `force` column 0 is the axial force at rest, column 1 + k its growth per m/s of driven tool k.
Eigen::VectorXd drive(const Problem& problem, const std::vector<Index>& driven, const Eigen::MatrixXd& force) {
  const auto count = static_cast<Index>(driven.size());
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(count);
  if (count == 0) return velocity;
  std::vector<bool> limited(count, false);
  for (Index round = 0; round <= count; ++round) {
    Eigen::MatrixXd resistance = Eigen::MatrixXd::Identity(count, count);
    Eigen::VectorXd rhs = velocity;
    for (Index k = 0; k < count; ++k) {
      if (limited[k]) continue;
      resistance.row(k) = force.block(k, 1, 1, count);
      rhs[k] = *problem.tools[driven[k]].force - force(k, 0);
    }
    for (Index k = 0; k < count; ++k)
      if (!limited[k] && resistance(k, k) <= 0) {  // nothing resists
        limited[k] = true;
        velocity[k] = std::copysign(problem.tools[driven[k]].speed_limit, rhs[k]);
        resistance.row(k) = Eigen::RowVectorXd::Unit(count, k);
        rhs[k] = velocity[k];
      }
    const double least = min_resistance * resistance.diagonal().maxCoeff();
    for (Index k = 0; k < count; ++k)
      if (!limited[k]) resistance(k, k) += least;
    velocity = resistance.partialPivLu().solve(rhs);
    Index furthest = -1;  // over its limit, of those not yet held by it
    double most = 1;
    for (Index k = 0; k < count; ++k)
      if (const double fraction = std::abs(velocity[k]) / problem.tools[driven[k]].speed_limit;
          !limited[k] && fraction > most) {
        most = fraction;
        furthest = k;
      }
    if (furthest < 0) break;
    velocity[furthest] = std::copysign(problem.tools[driven[furthest]].speed_limit, velocity[furthest]);
    limited[furthest] = true;
  }
  return velocity;
}

}  // namespace

Instant balance_tools(const Problem& problem, const std::vector<NodeConstraint>& constraints,
                      const Eigen::MatrixXd& solution, const Eigen::MatrixXd& reaction) {
  const auto driven = driven_tools(problem);
  const auto columns = solution.cols();
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(Index(driven.size()), columns);
  std::vector<ContactForces> parts;
  for (Index column = 0; column < columns; ++column) {
    parts.push_back(contact_forces(problem, constraints, reaction.col(column)));
    for (std::size_t i = 0; i < problem.candidates.size(); ++i)
      for (std::size_t k = 0; k < driven.size(); ++k)
        if (problem.candidates[i].tool == driven[k]) force(k, column) += parts.back().axial[i];
  }
  const Eigen::VectorXd velocity = drive(problem, driven, force);
  Instant instant{solution.col(0), parts[0], {}};
  for (const auto& tool : problem.tools) instant.tool_velocity.push_back(tool.velocity);
  for (std::size_t k = 0; k < driven.size(); ++k) {
    instant.unknowns += velocity[k] * solution.col(1 + k);
    instant.forces.normal += velocity[k] * parts[1 + k].normal;
    instant.forces.axial += velocity[k] * parts[1 + k].axial;
    instant.forces.sideways += velocity[k] * parts[1 + k].sideways;
    instant.tool_velocity[driven[k]] = velocity[k];
  }
  return instant;
}

using core::dim;

double friction_power(const Constraints& constraints, const Instant& instant) {
  double power = 0;
  for (const auto& constraint : constraints.nodes) {
    if (constraint.friction_tool < 0) continue;
    const Point relative = node_velocity(instant.unknowns, constraint.node) -
                           instant.tool_velocity[constraint.friction_tool] * core::axis_direction();
    const double slip = constraint.basis.col(dim - 1).dot(relative);
    power += (constraints.tangential_stiffness[constraint.node] * slip + constraints.tangential_load[constraint.node]) *
             slip;
  }
  return power;
}

double impact_power(const Problem& problem, const std::vector<bool>& active, const ContactForces& forces) {
  double power = 0;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (!active[i]) continue;
    const auto& candidate = problem.candidates[i];
    if (candidate.rate < 0) power -= forces.normal[i] * candidate.rate;
    if (sticks(problem, candidate))
      power -= forces.sideways[i] * (1 - candidate.contact_fraction) *
               candidate.approach_velocity.dot(perpendicular(candidate.normal));
  }
  return power;
}

double correction_power(const Problem& problem, const std::vector<bool>& active, const ContactForces& forces,
                        const Eigen::VectorXd& pressure, const Eigen::VectorXd& volume_load) {
  double power = pressure.dot(volume_load);
  for (std::size_t i = 0; i < active.size(); ++i)
    if (active[i] && problem.candidates[i].rate > 0) power -= forces.normal[i] * problem.candidates[i].rate;
  return power;
}

using core::dim;

std::vector<Index> constrained_batches(const core::Mesh& mesh, const Constraints& constraints) {
  std::vector<Index> batches;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells()[c];
    if (!batches.empty() && batches.back() == c / batch_size) continue;
    if (std::any_of(nodes.begin(), nodes.end(), [&](Index node) { return constraints.find(node); }))
      batches.push_back(c / batch_size);
  }
  return batches;
}

Eigen::VectorXd unbalanced(const Problem& problem, const Constraints& constraints, const Eigen::VectorXd& load,
                           const Iterate& iterate) {
  Eigen::VectorXd residual = load - iterate.force;
  const auto tools = driven_tools(problem);
  for (const auto& constraint : constraints.nodes) {
    if (constraint.friction_tool < 0) continue;
    const Point along = constraint.basis.col(dim - 1);
    const auto k = std::find(tools.begin(), tools.end(), constraint.friction_tool);
    const double wall =
        k == tools.end() ? problem.tools[constraint.friction_tool].velocity : iterate.driven[k - tools.begin()];
    const double slip = along.dot(node_velocity(iterate.x, constraint.node) - wall * core::axis_direction());
    residual.segment<dim>(dim * constraint.node) -=
        (constraints.tangential_stiffness[constraint.node] * slip + constraints.tangential_load[constraint.node]) *
        along;
  }
  return residual;
}

double imbalance(const Problem& problem, const CellMatrices& cells, const Constraints& constraints,
                 const Eigen::VectorXd& load, Iterate& iterate) {
  const Eigen::MatrixXd parts = product_and_size(*problem.mesh, cells, iterate.x);
  iterate.force = parts.col(0);
  const Eigen::VectorXd size = parts.col(1) + load.cwiseAbs();
  Eigen::VectorXd residual = unbalanced(problem, constraints, load, iterate);
  for (const auto& constraint : constraints.nodes)
    for (int a = 0; a < dim; ++a)
      if (constraint.fixed[a]) {
        auto there = residual.segment<dim>(dim * constraint.node);
        there -= (constraint.basis.col(a).dot(there) * constraint.basis.col(a)).eval();
      }
  double max_imbalance = 0;
  for (Index i = 0; i < residual.size(); ++i)
    if (residual[i] != 0) max_imbalance = std::max(max_imbalance, std::abs(residual[i]) / size[i]);
  return max_imbalance;
}

}  // namespace parison::flow
