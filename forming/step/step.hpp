#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/step_result.hpp"
#include "forming/step/workspace.hpp"

namespace parison::forming {

/// One staggered step of length dt, of second order: flow on the mid-step mesh at the temperature predicted for the
/// middle, half the motion, interface and heat in all bodies, the other half. The given state is left as it is; a step
/// that failed is a dropped value.
StepResult coupled_step(const Scene& scene, const State& state, double dt, Workspace& workspace);

}  // namespace parison::forming
