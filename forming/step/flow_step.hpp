#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/step.hpp"

namespace parison::forming {

/// The middle of a step as it is known before the step is solved.
struct MidpointPredictor {
  Eigen::VectorXd velocity, temperature;  ///< of the glass nodes, m/s, K
  bool trusted = false;  ///< the velocity: it comes from a coupling iteration, or a smooth motion predicts it
  std::vector<flow::ContactCandidate>
      bounds;  ///< of earlier coupling iterations, for nodes that later bounds did not keep out
};

/// Velocities, contact and work of a step by the flow, put into `result`: swept until the mesh in the step's middle
/// settles and the contact holds. `predictor` ends as the last coupling iteration left it; an unsuccessful solve is
/// told in `result.reason`.
bool iterate_until_converged(const Scene& scene, const State& state, MidpointPredictor& predictor, double dt,
                             Workspace& workspace, StepResult& result);

}  // namespace parison::forming
