#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/clock.hpp"
#include "forming/run/run.hpp"
#include "forming/step/workspace.hpp"

namespace parison::forming {

/// Length of a step after one that was rejected, of that one.
inline constexpr double shorten = 0.4;

/// A run in progress; private to the files of the run loop.
struct RunInProgress {
  const Scene& scene;
  const Observers& observers;
  const StopRequest& stop;
  const remesh::Mesher& mesher;
  RunOutcome outcome;
  Workspace workspace = {};
  /// Clocks at the start less the times before it, where the run was taken up again, s.
  double wall_start = core::wall_seconds() - outcome.facts.wall_seconds;
  double cpu_start = core::thread_cpu_seconds() - outcome.facts.cpu_seconds;
};

/// Puts the wall and CPU time of the whole run so far into its facts.
void update_times(RunInProgress& run);

/// Calls a function of all observers. Their time counts as that of the output.
template <typename... Parameters, typename... Arguments>
void notify(RunInProgress& run, void (RunObserver::*event)(const RunView&, Parameters...),
            const Arguments&... arguments) {
  update_times(run);
  const core::ScopedTimer timer(run.outcome.facts.timing["output"]);
  for (RunObserver* observer : run.observers)
    (observer->*event)({run.scene, run.outcome.state, run.outcome.facts, run.outcome.solid}, arguments...);
}

/// Tells the observers that a checkpoint is possible, where one is: not while the heat of a static stage is in an
/// integrator with a memory of its own, which ends after `output.checkpoint_steps` steps and after 300 of its own.
void offer_checkpoint(RunInProgress& run, bool at_stage_boundary);

/// Puts a sentence into the facts as the reason why the run ends; false where it is empty and the run goes on.
bool ends_by(RunInProgress& run, std::string reason);

/// Whether the run was stopped on request; this is recorded in the facts.
bool stop_requested(RunInProgress& run);

}  // namespace parison::forming
