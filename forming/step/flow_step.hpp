#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/fixed_point.hpp"
#include "forming/step/step.hpp"
#include "forming/step/step_start.hpp"

namespace parison::forming {

/// The middle of a step as predicted before the step is solved.
struct MidpointPredictor {
  Eigen::VectorXd velocity, temperature;  ///< of the glass nodes, m/s, K
  bool trusted = false;  ///< the velocity: it comes from a coupling iteration, or a smooth motion predicts it
  std::vector<flow::ContactCandidate>
      bounds;                 ///< of earlier coupling iterations, for nodes that later bounds did not keep out
  FixedPoint iteration = {};  ///< of the velocity
};

/// Velocities, contact and work of a step, stored in `result`: the flow is solved on the midpoint mesh of its own
/// velocities, in fixed-point iterations until that mesh has converged and the contact no longer changes. `predictor`
/// is left as the last iteration made it; `result.reason` gives the reason why the step failed.
bool iterate_until_converged(const StepStart& start, MidpointPredictor& predictor, Workspace& workspace,
                             StepResult& result);

}  // namespace parison::forming
