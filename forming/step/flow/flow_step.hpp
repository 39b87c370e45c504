#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/flow/predictor.hpp"
#include "forming/step/step.hpp"
#include "forming/step/step_start.hpp"

namespace parison::forming {

/// Velocities, contact and work of a step, stored in `result`: the flow is solved on the midpoint mesh of its own
/// velocities, in fixed-point iterations until that mesh has converged and the contact no longer changes. `predictor`
/// is left as the last iteration made it; `result.reason` gives the reason why the step failed.
bool iterate_until_converged(const StepStart& start, MidpointPredictor& predictor, Workspace& workspace,
                             StepResult& result);

/// Moves the probes of the glass with its velocities, m/s on a mesh, for a time of dt, s.
void move_glass_probes(const Scene& scene, const core::Mesh& mesh, const Eigen::VectorXd& velocity, double dt,
                       State& state);

}  // namespace parison::forming
