// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/run.hpp"

#include <fmt/core.h>

#include <utility>

#include "core/process/run_error.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/checks/solid_checks.hpp"
#include "forming/run/run_in_progress.hpp"
#include "forming/run/solid_stages.hpp"
#include "forming/run/stage.hpp"
#include "forming/run/stall.hpp"
#include "forming/run/step_loop.hpp"
#include "forming/run/warnings.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/interpolate.hpp"
#include "forming/step/contact/film.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {

namespace {

/// Tells the observers of a step, and of the output times within it and at the stage's end.
void report_step(RunInProgress& run, const AcceptedStep& step) {
  const State& state = run.outcome.state;
  notify(run, &RunObserver::step_taken, step.before, step.report);
  for (const double time : outputs_due(run.scene, step.before.stage, step.before.time, state.time))
    notify(run, &RunObserver::fields_due, interpolate(step.before, state, time));
  if (stage_end(run.scene, state) != StageEnd::none)
    notify(run, &RunObserver::fields_due, interpolate(step.before, state, state.time));
}

/// Whether glass between tools is too thin to go on, or the run has no use to go on; the reason goes into the facts.
bool is_too_thin_or_stalled(RunInProgress& run, StallWatch& watch) {
  const State& state = run.outcome.state;
  if (!run.scene.has_flow() || run.scene.stages[state.stage].cools) return false;
  return ends_by(run, film_failure(run.scene, state)) ||
         ends_by(run, watch.reason(run.scene, state, run.outcome.facts.diagnostics));
}

/// Steps until the stage is over. Wherever a checkpoint is possible the run can enter here again.
bool advance_stage(RunInProgress& run) {
  State& state = run.outcome.state;
  AcceptedStep step;
  StallWatch watch;
  while (stage_end(run.scene, state) == StageEnd::none) {
    if (!advance(run, step)) return false;
    update_motion(run.scene, state);
    report_step(run, step);
    if (is_too_thin_or_stalled(run, watch) || has_outgrown_tool(run)) return false;
    offer_checkpoint(run, false);
    if (stop_requested(run)) return false;
  }
  return true;
}

/// The stages from the present one on, which has begun if `good`; false when one cannot end.
bool run_stages(RunInProgress& run, bool good) {
  const auto stages = static_cast<Index>(run.scene.stages.size());
  for (;;) {
    good = good && advance_stage(run);
    offer_checkpoint(run, true);
    if (!good) notify(run, &RunObserver::fields_due, run.outcome.state);
    end_stage(run, good);
    notify(run, &RunObserver::stage_ends);
    const Index next = run.outcome.state.stage + 1;
    if (!good || next == stages) return good;
    if (run.scene.solid && next == run.scene.solid->from_stage) return run_solid_stages(run);
    good = begin_stage(run, next);
  }
}

/// Runs `from_here` to the end of the run, which an error of the system may be, and completes the facts.
template <typename Work>
RunOutcome finish(RunInProgress& run, const Work& from_here) {
  State& state = run.outcome.state;
  RunFacts& facts = run.outcome.facts;
  try {
    facts.completed = from_here();
  } catch (const core::RunError& error) {
    facts.completed = false;
    facts.reason = error.what();
    facts.interrupted = dynamic_cast<const core::SystemError*>(&error) != nullptr;
    end_stage(run, false);
  }
  const std::string& stage = run.scene.stages[state.stage].name;
  const std::string entered = entered_face_sentence(run.scene, facts.diagnostics.in_tools);
  if (!entered.empty() && !facts.stopped && !facts.interrupted)
    facts.reason = fmt::format("{} (what stopped it: {})", entered, facts.reason);
  facts.reason = facts.completed ? "" : fmt::format("stage {} at {:.5f} s: {}", stage, state.time, facts.reason);
  if (facts.reason.find(facts.unfilled) == std::string::npos) add_warnings({facts.unfilled}, facts);
  add_warnings(remeshing_warnings(state), facts);
  facts.checks = checks(run.scene, state, facts);
  if (run.outcome.solid) add_solid_checks(run.scene, state, *run.outcome.solid, facts, facts.checks);
  if (facts.completed && !run.outcome.solid) add_warnings(unused_interface_warnings(run.scene, state), facts);
  notify(run, &RunObserver::run_ends);
  return std::move(run.outcome);
}

}  // namespace

RunOutcome run(const Scene& scene, const Observers& observers, const StopRequest& stop, const remesh::Mesher& mesher) {
  RunInProgress run{scene, observers, stop, mesher, {initial_state(scene), {}}};
  run.outcome.facts.diagnostics = first_diagnostics(scene, run.outcome.state);
  notify(run, &RunObserver::run_begins);
  return finish(run, [&] {
    const bool good = begin_stage(run, 0);
    offer_checkpoint(run, true);
    return run_stages(run, good);
  });
}

RunOutcome resume(const Scene& scene, RunOutcome from, const Observers& observers, const StopRequest& stop,
                  const remesh::Mesher& mesher) {
  RunInProgress run{scene, observers, stop, mesher, std::move(from)};
  const State& state = run.outcome.state;
  notify(run, &RunObserver::run_begins);
  return finish(run, [&] {
    if (run.outcome.solid) return run_solid_stages(run);
    return run_stages(run, state.stage_time > 0 ||
                               !ends_by(run, after_press(run.outcome.facts, stage_precondition_failure(scene, state))));
  });
}

}  // namespace parison::forming
