#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/solution.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Accumulates the work of a step of dt from `start` with the velocities and forces of `flow`. Gravity, air and surface
/// are taken from where the step really carries the glass, not from the equations that the flow solved.
void accumulate_work(const Scene& scene, const State& start, const flow::Solution& flow, double dt, Work& work);

/// Work done on the glass that is neither lost nor stored in its surface, relative to what was lost; NaN where nothing
/// was.
double work_imbalance(const Work& work);

}  // namespace parison::forming
