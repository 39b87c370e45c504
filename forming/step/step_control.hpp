#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/step_result.hpp"

namespace parison::forming {

struct ProposedStep {
  double dt;  ///< s
  StepLimit limit;
};

/// Step that the next step may have, from what the last one did to the mesh and the surface temperature; `allowed`, s,
/// is what that one was allowed, before it was shortened to land on a given time.
ProposedStep propose_step(const Scene& scene, const StepReport& report, double allowed);

/// Whether a step did so much more than it should that it is to be repeated shorter.
bool rejected_by_error_control(const Scene& scene, const StepReport& report);

/// `proposed`, shortened so that the stage's end is met exactly and no sliver is left before it; where nothing flows,
/// the next output time as well (the heat integrator's own steps do not care).
double clip_step_to_event(const Scene& scene, const State& state, double proposed);

/// Output times after `from` and not after `to`, s, in order.
std::vector<double> outputs_due(const Scene& scene, double from, double to);

/// Whether the present stage is over: its duration, or its tools have come to rest after having moved.
bool stage_over(const Scene& scene, const State& state, bool has_moved);

}  // namespace parison::forming
