// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/run_in_progress.hpp"

#include <utility>

#include "forming/step/step_control.hpp"

namespace parison::forming {

void update_times(RunInProgress& run) {
  run.outcome.facts.wall_seconds = core::wall_seconds() - run.wall_start;
  run.outcome.facts.cpu_seconds = core::thread_cpu_seconds() - run.cpu_start;
}

void offer_checkpoint(RunInProgress& run, bool at_stage_boundary) {
  const State& state = run.outcome.state;
  const auto& static_stage = run.workspace.static_stage;
  const bool in_integrator = static_stage && !static_stage->expired && stage_end(run.scene, state) == StageEnd::none;
  if (!in_integrator) notify(run, &RunObserver::checkpoint_possible, at_stage_boundary);
}

bool ends_by(RunInProgress& run, std::string reason) {
  run.outcome.facts.reason = std::move(reason);
  return !run.outcome.facts.reason.empty();
}

bool stop_requested(RunInProgress& run) {
  RunFacts& facts = run.outcome.facts;
  if (!run.stop || !run.stop()) return false;
  facts.stopped = true;
  facts.reason = "the run was stopped on request";
  return true;
}

}  // namespace parison::forming
