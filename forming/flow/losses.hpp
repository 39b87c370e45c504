#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/tool_balance.hpp"

namespace parison::flow {

/// What friction takes where the glass slides along tools, W.
double friction_power(const Held& held, const Instant& instant);

/// Of glass that lands on tools within a step, W. A node moves freely until it lands and rests from then on, so the tool does no
/// work on it; the means of force and velocity over the step do, and that is what the mean velocities dissipate too little.
double arrival_power(const Problem& problem, const std::vector<bool>& active, const ContactForces& forces);

/// What it takes to lead the volume back against the pressure, W, less what tools give to nodes that they lead out of themselves;
/// `volume_load` is the wanted change of volume, m3/s, per vertex.
double correction_power(const Problem& problem, const std::vector<bool>& active, const ContactForces& forces,
                        const Eigen::VectorXd& pressure, const Eigen::VectorXd& volume_load);

}  // namespace parison::flow
