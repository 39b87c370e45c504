#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/step.hpp"

namespace parison::forming {

/// The middle of a step as it is known before the step is solved.
struct Middle {
  Eigen::VectorXd velocity, temperature;       ///< of the glass nodes, m/s, K
  bool trusted = false;                        ///< the velocity: it comes from a sweep, or a smooth motion foretells it
  std::vector<flow::ContactCandidate> bounds;  ///< of earlier sweeps, for nodes that later bounds did not keep out
};

/// Velocities, contact and work of a step by the flow, put into `result`: swept until the mesh in the step's middle
/// settles and the contact holds. `foretold` ends as the last sweep left it; an unsuccessful solve is told in
/// `result.reason`.
bool sweep_until_settled(const Scene& scene, const State& state, Middle& foretold, double dt, Workspace& workspace,
                         StepResult& result);

}  // namespace parison::forming
