#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// What steps of forming and of cooling have in common.
#include "forming/step/step_result.hpp"
#include "forming/step/step_start.hpp"
#include "forming/step/workspace.hpp"

namespace parison::forming {

/// Moves the glass and the active tools with their velocities for a time of dt, s.
void move_bodies(const Scene& scene, double dt, StepResult& result);

/// Whether every cell of the glass has kept its sense.
bool has_no_inverted_cells(const Scene& scene, StepResult& result);

/// Heat over a step of dt, s, on the bodies and the interface at their positions in its middle. False where there is
/// none, with the reason.
bool step_heat(const Scene& scene, double dt, Workspace& workspace, StepResult& result);

/// Carries the clock, the openings of contacts and the forces of tools to the end of the step.
void finish(const StepStart& start, State& after);

}  // namespace parison::forming
