#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Removes from a nodal velocity (two per node, m/s) what crosses the symmetry lines of `mesh`, so that their nodes
/// stay on them to the bit where they are parallel to an axis.
void keep_on_symmetry(const core::Mesh& mesh, Eigen::VectorXd& velocity);

/// Temperature of the glass after `dt` at the rate of the last step, changed by no more than a step may change it, K
/// per node.
Eigen::VectorXd predicted_temperature(const Scene& scene, const State& state, double dt);

/// Velocity of the glass nodes `ahead` after the state, from the last two steps while the motion is smooth; nodes in
/// contact do not move into their tool.
Eigen::VectorXd predicted_velocity(const State& state, double ahead);

/// Mesh of the glass in the middle of a step with velocity `midpoint_velocity` there, to third order in the step;
/// its volume is the first.
core::Mesh midpoint_mesh(const Scene& scene, const State& state, const Eigen::VectorXd& midpoint_velocity, double dt);

/// Accumulates in `after`, a step of length dt behind `before`, the rates from which the next step is predicted. Nodes
/// whose contact changed in the last two steps are given no acceleration.
void update_rates(const State& before, double dt, State& after);

}  // namespace parison::forming
