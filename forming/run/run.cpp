// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <exception>

#include "forming/remeshing/remesh_state.hpp"
#include "forming/report/files/history.hpp"
#include "forming/report/summary_parts.hpp"
#include "forming/run/progress.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/interpolate.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/film.hpp"
#include "forming/step/step.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {

namespace {

/// Shortest step after a rejected one, of the rejected one.
constexpr double shorten = 0.4, longest_retry = 0.9;

constexpr const char* remesh_advice = "a smaller numerics.surface_size or a larger numerics.quality_floor may help";

/// A new glass mesh for the present state; false when none could be made and the old one cannot go on.
bool remesh_glass(Progress& run, RemeshReason why) {
  const bool must = why == RemeshReason::failed_step;
  const auto start = Clock::now();
  auto remeshed = remesh_state(run.scene, run.outcome.state, why);
  account(run, "remesh", start);
  if (remeshed.ok) {
    run.outcome.state = std::move(remeshed.state);
    run.workspace.flow.reset();
    return true;
  }
  const std::string sentence = fmt::format("no new glass mesh: {}", remeshed.reason);
  State& state = run.outcome.state;
  if (++state.totals.remeshing.failed == 1)
    run.outcome.facts.warnings.push_back(fmt::format("at {:.5f} s {}", state.time, sentence));
  auto& reason = run.outcome.facts.reason;
  if (must) reason += fmt::format("{}{}; {}", reason.empty() ? "" : "; ", sentence, remesh_advice);
  return !must;
}

/// What a step did and the state that it began with.
struct AcceptedStep {
  State before;
  StepReport report;
};

/// Whether the run was stopped on request; then the facts say so.
bool stop_requested(Progress& run) {
  RunFacts& facts = run.outcome.facts;
  if (!run.stop || !run.stop()) return false;
  facts.stopped = true;
  facts.reason = "the run was stopped on request";
  return true;
}

/// A step that converged and kept within its allowance; false when the smallest one did not.
bool step_once(Progress& run, AcceptedStep& step) {
  State& state = run.outcome.state;
  auto limit = static_cast<StepLimit>(state.next_limit);
  double dt = clip_step_to_event(run.scene, state, state.next_step);
  if (dt < state.next_step) limit = StepLimit::event;
  for (;;) {
    auto result = coupled_step(run.scene, state, dt, run.workspace);
    result.report.limit = limit;
    for (const auto& [part, seconds] : result.report.seconds) run.outcome.facts.timing[part] += seconds;
    const bool accepted = result.converged && !rejected_by_error_control(run.scene, result.report);
    add_step(result.report, accepted, run.outcome.facts.solver_statistics);
    const ProposedStep proposed = propose_step(run.scene, result.report, accepted ? state.next_step : dt);
    if (accepted) {
      result.state.next_step = proposed.dt;
      result.state.next_limit = static_cast<Index>(proposed.limit);
      step = {std::move(state), std::move(result.report)};
      state = std::move(result.state);
      run.outcome.facts.reason.clear();
      return true;
    }
    ++state.totals.rejected;
    run.workspace.static_stage.reset();
    run.outcome.facts.reason = result.converged ? "the step deforms the glass too much" : result.reason;
    dt = result.converged ? std::clamp(proposed.dt, shorten * dt, longest_retry * dt) : shorten * dt;
    if (result.unrecoverable) return false;
    if (dt < run.scene.accuracy.min_step) {
      run.outcome.facts.reason +=
          fmt::format("; steps below {:g} s, numerics.min_step, would be needed", run.scene.accuracy.min_step);
      return false;
    }
    limit = result.converged ? proposed.limit : StepLimit::failure;
    state.next_step = dt;
    state.next_limit = static_cast<Index>(limit);
    if (stop_requested(run)) return false;
  }
}

/// A tool deeper than this in the glass at a stage's start is an error of the scene, m.
constexpr double max_overlap = 0.5e-3;

/// What makes the stage impossible from where the tools and the glass stand; empty when nothing does.
std::string stage_precondition_failure(const Scene& scene, const State& state) {
  for (const auto& place : scene.stages[state.stage].tools) {
    const auto* position = std::get_if<PositionMotion>(&place.motion);
    const double now = state.tools[place.tool].offset;
    if (position && std::abs(position->offset(0) - now) > 1e-6)
      return fmt::format("tool {} stands at {:.4g} mm, its motion starts at {:.4g} mm", scene.tools[place.tool].name,
                         1e3 * now, 1e3 * position->offset(0));
  }
  Penetration max_penetration{};
  for (const Penetration& inside : penetrations(scene, state, 0))
    if (inside.depth > max_penetration.depth) max_penetration = inside;
  if (max_penetration.depth <= max_overlap) return "";
  const Point& x = state.glass.mesh.nodes[max_penetration.node];
  return fmt::format(
      "tool {} in place overlaps the glass by {:.3g} mm at ({:.4g}, {:.4g}) mm; the glass does not fit into the "
      "stage's tools as it is",
      scene.tools[max_penetration.tool].name, 1e3 * max_penetration.depth, 1e3 * x[0], 1e3 * x[1]);
}

/// Whether the stage can begin; the reason why not goes into the facts.
bool can_begin(Progress& run) {
  run.outcome.facts.reason = stage_precondition_failure(run.scene, run.outcome.state);
  return run.outcome.facts.reason.empty();
}

/// Enters a stage; false when it cannot begin.
bool begin_stage(Progress& run, Index stage) {
  State& state = run.outcome.state;
  const std::string misplaced = misplaced_boundary(run.scene, state, stage);
  state = start_stage(run.scene, state, stage);
  state.next_step = run.scene.accuracy.initial_step;
  state.next_limit = static_cast<Index>(StepLimit::initial);
  run.workspace.static_stage.reset();
  bool good = can_begin(run);
  if (!misplaced.empty()) {
    run.outcome.facts.reason = misplaced;
    good = false;
  }
  if (stage == 0) write_fields(run, state);
  return good && (stage == 0 || !run.scene.has_flow() || remesh_glass(run, RemeshReason::stage_start));
}

/// Tools that were to come to rest in a stage whose duration was too short for that.
void warn_of_moving_tools(Progress& run) {
  const State& state = run.outcome.state;
  const Stage& stage = run.scene.stages[state.stage];
  for (const StageTool& tool : stage.tools) {
    const double speed = std::abs(state.tools[tool.tool].velocity);
    if (stage.end_speed && std::holds_alternative<ForceMotion>(tool.motion) && speed >= *stage.end_speed)
      run.outcome.facts.warnings.push_back(fmt::format(
          "stage {} ended by its duration of {:g} s while {} still moved at {:.3g} mm/s, above its end_speed of {:g} "
          "mm/s",
          stage.name, stage.duration, run.scene.tools[tool.tool].name, 1e3 * speed, 1e3 * *stage.end_speed));
  }
}

void end_stage(Progress& run, bool good) {
  const State& state = run.outcome.state;
  const Stage& stage = run.scene.stages[state.stage];
  RunFacts& facts = run.outcome.facts;
  const bool full = state.stage_time >= stage.duration - 1e-9;
  const char* reason = facts.stopped ? "stop" : !good ? "failure" : full ? "duration" : "tools at rest";
  facts.stages.push_back({stage.name, state.stage_start, state.time, reason, state.totals.work});
  if (good && full && !facts.stopped) warn_of_moving_tools(run);
}

/// One step of the stage, after a new mesh where that is needed; false when none can be made.
bool advance(Progress& run, AcceptedStep& step) {
  const Scene& scene = run.scene;
  if (scene.has_flow() && needs_remesh(scene, run.outcome.state) && !remesh_glass(run, RemeshReason::quality))
    return false;
  if (step_once(run, step)) return true;
  if (run.outcome.facts.stopped) return false;
  // A mesh that is still sound may be what holds the step back.
  return scene.has_flow() && remesh_glass(run, RemeshReason::failed_step) && step_once(run, step);
}

void update_motion(const Scene& scene, State& state) {
  const Stage& stage = scene.stages[state.stage];
  for (const auto& tool : stage.tools) {
    ToolState& body = state.tools[tool.tool];
    if (!std::holds_alternative<ForceMotion>(tool.motion)) continue;
    if (stage.end_speed && std::abs(body.velocity) > *stage.end_speed) state.has_moved = true;
    body.peak_force = std::max(body.peak_force, std::abs(body.force));
  }
}

/// A row of the history; the fields at the output times within the step and at the stage's end.
void write_step(Progress& run, const AcceptedStep& step) {
  const State& state = run.outcome.state;
  const auto start = Clock::now();
  run.files.row(history_row(run.scene, state, step.report));
  account(run, "output", start);
  for (const double time : outputs_due(run.scene, step.before.time, state.time))
    write_fields(run, time < state.time ? interpolate(step.before, state, time) : state);
  if (stage_over(run.scene, state, state.has_moved)) write_fields(run, state);
  print_progress(run, step.report);
}

/// Whether glass between tools is too thin to go on; the reason goes into the facts.
bool is_too_thin(Progress& run) {
  if (!run.scene.has_flow()) return false;
  run.outcome.facts.reason = film_failure(run.scene, run.outcome.state);
  return !run.outcome.facts.reason.empty();
}

/// Steps until the stage is over. Wherever a checkpoint is written the run can enter here again.
bool advance_stage(Progress& run) {
  State& state = run.outcome.state;
  AcceptedStep step;
  while (!stage_over(run.scene, state, state.has_moved)) {
    if (!advance(run, step)) return false;
    update_motion(run.scene, state);
    write_step(run, step);
    if (is_too_thin(run)) return false;
    save_when_due(run);
    if (stop_requested(run)) return false;
  }
  return true;
}

/// Interfaces over which no heat went in the whole run; bodies that start at one temperature say nothing.
void warn_of_unused_interfaces(Progress& run) {
  const Scene& scene = run.scene;
  for (const Interface& interface : scene.interfaces) {
    const Tool& tool = scene.tools[interface.tool];
    if (run.outcome.state.tools[interface.tool].heat_received == 0 &&
        tool.initial_temperature != scene.glass.initial_temperature)
      run.outcome.facts.warnings.push_back(
          fmt::format("the interface of the glass with {} was never used: in the whole run they did not come within "
                      "{:.4g} mm of each "
                      "other",
                      tool.name, 1e3 * interface.transition_gap));
  }
}

/// Of the span of the scene's temperatures; more is told.
constexpr double overshoot_limit = 0.1;
/// Of the work; more is told.
constexpr double work_imbalance_limit = 1e-3;
/// Contacts held closed against a pull for each step; more is told.
constexpr double locked_limit = 0.1;

void warn(Progress& run) {
  const Totals& totals = run.outcome.state.totals;
  auto& warnings = run.outcome.facts.warnings;
  if (totals.max_reynolds > 1)
    warnings.push_back(
        fmt::format("inertia was left out, but the Reynolds number reached {:.2g}", totals.max_reynolds));
  const RemeshStatistics& remeshing = totals.remeshing;
  if (remeshing.failed > 1) warnings.push_back(fmt::format("{} new glass meshes could not be made", remeshing.failed));
  if (remeshing.laps > 0)
    warnings.push_back(fmt::format(
        "the glass folded onto itself at {} places, which were closed with {:.2g} mm3 of air in them: marks of "
        "laps are to be expected there",
        remeshing.laps, 1e9 * remeshing.lap_volume));
  if (remeshing.coarsening_factor > 1)
    warnings.push_back(fmt::format("a glass mesh was {:.3g} times coarser than asked for, to have about {:g} cells",
                                   remeshing.coarsening_factor, run.scene.accuracy.max_cells));
  if (const double imbalance = max_work_imbalance(run.outcome.facts); imbalance > work_imbalance_limit)
    warnings.push_back(
        fmt::format("the work done on the glass and what became of it differ by {:.2g} % at a stage's end; a higher "
                    "accuracy or a smaller "
                    "numerics.strain_per_step helps",
                    100 * imbalance));
  if (totals.clamped_lookups > 0)
    warnings.push_back(fmt::format("a conductance table was asked {} times outside its range", totals.clamped_lookups));
  if (const double span = temperature_range(run.scene).span(); totals.overshoot > overshoot_limit * span)
    warnings.push_back(
        fmt::format("a temperature rose {:.0f} K above the hottest of the scene for a moment, {:.2g} % of the span "
                    "of all: skins too thin for the mesh; a smaller numerics.skin_size helps",
                    totals.overshoot, 100 * totals.overshoot / span));
  if (const long locked = run.outcome.facts.solver_statistics.locked_contacts;
      double(locked) > locked_limit * double(totals.steps))
    warnings.push_back(fmt::format(
        "in all steps together {} contacts stayed closed although they pull, as they kept opening and closing",
        locked));
}

/// The stages from the present one on, which has begun if `good`; false when one cannot end.
bool go_through_stages(Progress& run, bool good) {
  const auto stages = static_cast<Index>(run.scene.stages.size());
  for (;;) {
    good = good && advance_stage(run);
    save(run);
    if (!good) write_fields(run, run.outcome.state);
    end_stage(run, good);
    const Index next = run.outcome.state.stage + 1;
    if (!good || next == stages) return good;
    good = begin_stage(run, next);
  }
}

/// Runs `from_here` to the end of the run; what the system refuses ends it as well.
RunOutcome finish(Progress& run, const std::function<bool()>& from_here) {
  auto& [state, facts] = run.outcome;
  try {
    facts.completed = from_here();
  } catch (const std::exception& error) {
    facts.completed = false;
    facts.reason = error.what();
    end_stage(run, false);
  }
  if (facts.completed)
    facts.reason.clear();
  else
    facts.reason =
        fmt::format("stage {} at {:.5f} s: {}", run.scene.stages[state.stage].name, state.time, facts.reason);
  warn(run);
  if (facts.completed) warn_of_unused_interfaces(run);
  update_times(run);
  return std::move(run.outcome);
}

}  // namespace

RunOutcome run(const Scene& scene, const std::string& directory, const StopRequest& stop) {
  State start = initial_state(scene);  // first: where an outline cannot be meshed no folder is left
  Progress run{scene, stop, ResultFiles(scene, directory), {}};
  run.outcome.state = std::move(start);
  return finish(run, [&] {
    const bool good = begin_stage(run, 0);
    save(run);
    return go_through_stages(run, good);
  });
}

RunOutcome resume(const Scene& scene, const std::string& directory, const StopRequest& stop) {
  Checkpoint from = read_checkpoint(find_checkpoint(directory), scene);
  Progress run{scene, stop, ResultFiles(scene, directory, from.files), std::move(from.outcome)};
  const State& state = run.outcome.state;
  run.wall_before = run.outcome.facts.wall_seconds;
  run.cpu_before = run.outcome.facts.cpu_seconds;
  run.fraction_before = fraction_done(run);
  run.checkpoint_steps = state.totals.steps;
  fmt::print("  {:<10} t {:8.4f} s  step {:5}  {} remeshes so far\n", scene.stages[state.stage].name, state.time,
             state.totals.steps, remeshes(state));
  return finish(run, [&] { return go_through_stages(run, state.stage_time > 0 || can_begin(run)); });
}

}  // namespace parison::forming
