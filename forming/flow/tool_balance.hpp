#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/contact_forces.hpp"

namespace parison::flow {

/// One iteration's outcome, all tools' velocities known.
struct Instant {
  Eigen::VectorXd unknowns;
  ContactForces forces;
  std::vector<double> tool_velocity;
};

/// Superposes `solution`, whose column 0 belongs to driven tools at rest and column 1 + k to each m/s of driven tool k, with the
/// nodal `reaction` likewise, so that the driven tools are in balance or at their speed limits.
Instant balance_tools(const Problem& problem, const std::vector<NodeFrame>& frames, const Eigen::MatrixXd& solution,
                      const Eigen::MatrixXd& reaction);

}  // namespace parison::flow
