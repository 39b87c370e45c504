// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/tool_balance.hpp"

#include <cmath>

#include <Eigen/LU>

namespace parison::flow {

namespace {

/// Share of the largest resistance by which tools that press glass against each other alone are kept from drifting.
constexpr double least_resistance = 1e-12;

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
    const double least = least_resistance * resistance.diagonal().maxCoeff();
    for (Index k = 0; k < count; ++k)
      if (!limited[k]) resistance(k, k) += least;
    velocity = resistance.partialPivLu().solve(rhs);
    Index furthest = -1;  // over its limit, of those not yet held by it
    double most = 1;
    for (Index k = 0; k < count; ++k)
      if (const double share = std::abs(velocity[k]) / problem.tools[driven[k]].speed_limit; !limited[k] && share > most) {
        most = share;
        furthest = k;
      }
    if (furthest < 0) break;
    velocity[furthest] = std::copysign(problem.tools[driven[furthest]].speed_limit, velocity[furthest]);
    limited[furthest] = true;
  }
  return velocity;
}

}  // namespace

Instant balance_tools(const Problem& problem, const std::vector<NodeFrame>& frames, const Eigen::MatrixXd& solution,
                      const Eigen::MatrixXd& reaction) {
  const auto driven = driven_tools(problem);
  const auto columns = solution.cols();
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(Index(driven.size()), columns);
  std::vector<ContactForces> parts;
  for (Index column = 0; column < columns; ++column) {
    parts.push_back(contact_forces(problem, frames, reaction.col(column)));
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

}  // namespace parison::flow
