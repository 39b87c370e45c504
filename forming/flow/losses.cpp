// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/losses.hpp"

namespace parison::flow {

using core::dim;

double friction_power(const Held& held, const Instant& instant) {
  double power = 0;
  for (const auto& frame : held.frames) {
    if (frame.friction_tool < 0) continue;
    const Point relative =
        node_velocity(instant.unknowns, frame.node) - instant.tool_velocity[frame.friction_tool] * core::axis_direction();
    const double slip = frame.frame.col(dim - 1).dot(relative);
    power += (held.drag[frame.node] * slip + held.pull[frame.node]) * slip;
  }
  return power;
}

double arrival_power(const Problem& problem, const std::vector<bool>& active, const ContactForces& forces) {
  double power = 0;
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (!active[i]) continue;
    const auto& candidate = problem.candidates[i];
    if (candidate.rate < 0) power -= forces.normal[i] * candidate.rate;
    if (sticks(problem, candidate))
      power -= forces.sideways[i] * (1 - candidate.share) * candidate.until.dot(perpendicular(candidate.normal));
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

}  // namespace parison::flow
