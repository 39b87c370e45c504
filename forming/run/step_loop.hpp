#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/run_in_progress.hpp"

namespace parison::forming {

/// What a step did and the state that it began with.
struct AcceptedStep {
  State before;
  StepReport report;
};

/// Takes one step of the stage that the step control accepts, on a new glass mesh where the old one is too distorted or
/// may be what limits the step. False when the smallest step failed or the run was stopped; the facts say why.
bool advance(RunInProgress& run, AcceptedStep& step);

/// Whether glass that hangs has become longer or wider than a tool of the next stage; the facts say so.
bool has_outgrown_tool(RunInProgress& run);

/// Gives the present state a new glass mesh. False when none could be made and the old one cannot go on; the facts say
/// why.
bool remesh_glass(RunInProgress& run, RemeshReason why);

}  // namespace parison::forming
