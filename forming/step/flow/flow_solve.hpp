#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/flow/solution.hpp"
#include "forming/step/flow/predictor.hpp"
#include "forming/step/step_start.hpp"
#include "forming/step/workspace.hpp"

namespace parison::forming {

/// The flow of one coupling iteration with the contact candidates that it was solved for.
struct FlowPass {
  std::vector<flow::ContactCandidate> candidates;
  flow::Solution solution;
};

/// Loads, tools and contact candidates of a step on the mesh in its middle, where the glass is expected to move with
/// `velocity`, m/s; `bounds` are more candidates. The temperature is left open.
flow::Problem loaded_problem(const StepStart& start, const core::Mesh& middle, const Eigen::VectorXd& velocity,
                             const std::vector<flow::ContactCandidate>& bounds);

/// Solves the flow on the predicted mesh in the middle of the step, and corrects its volume. The search for contacts
/// starts from those that were `active`.
FlowPass solve_flow(const StepStart& start, const ActiveContacts& active, const MidpointPredictor& predictor,
                    Workspace& workspace);

/// Stores velocities, contacts and tool forces in the state.
void store_flow(const Scene& scene, const FlowPass& pass, double dt, State& state);

}  // namespace parison::forming
