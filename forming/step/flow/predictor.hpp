#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/anderson.hpp"
#include "forming/flow/problem.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/balance/expansion.hpp"

namespace parison::forming {

/// The middle of a step as predicted before the step is solved.
struct MidpointPredictor {
  Eigen::VectorXd velocity, temperature;  ///< of the glass nodes, m/s, K
  bool trusted = false;  ///< the velocity: it comes from a coupling iteration, or a smooth motion predicts it
  std::vector<flow::ContactCandidate>
      bounds;  ///< of earlier coupling iterations, for nodes that later bounds did not keep out
  /// Of the velocity: plain iteration diverges where a wall under pressure bends faster than the step.
  core::AndersonAcceleration iteration = core::AndersonAcceleration();
  Expansion expansion = {};  ///< until the step's end
};

/// Removes from a nodal velocity (two per node, m/s) what crosses the symmetry lines of `mesh`, so that their nodes
/// stay on them to the bit where they are parallel to an axis.
void keep_on_symmetry(const core::Mesh& mesh, Eigen::VectorXd& velocity);

/// Temperature of the glass after `dt`, K per node: at the rate of the last step, which falls on as fast as between the
/// last two; changed by no more than a step may change it.
Eigen::VectorXd predicted_temperature(const Scene& scene, const State& state, double dt);

/// Velocity of the glass nodes `ahead` after the state, from the last two steps while the motion is smooth; nodes in
/// contact do not move into their tool.
Eigen::VectorXd predicted_velocity(const State& state, double ahead);

/// Mesh of the glass in the middle of a step with such velocities and temperatures there, to third order in the step;
/// its volume is the first, or that of its mass.
core::Mesh midpoint_mesh(const Scene& scene, const State& state, const MidpointPredictor& predictor, double dt);

/// Accumulates in `after`, a step of length dt behind `before`, the rates from which the next step is predicted. Nodes
/// whose contact changed in the last two steps are given no acceleration.
void update_rates(const State& before, double dt, State& after);

}  // namespace parison::forming
