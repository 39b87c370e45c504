// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "forming/checkpoint.hpp"
#include "forming/contact_geometry.hpp"
#include "forming/history.hpp"
#include "forming/initial_state.hpp"
#include "forming/output.hpp"
#include "forming/renew.hpp"
#include "forming/step.hpp"
#include "forming/step_control.hpp"

namespace parison::forming {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Shortest step after a rejected one, of the rejected one.
constexpr double shorten = 0.4;

/// A run in progress: what the loop below works on.
struct Progress {
  const Scene& scene;
  ResultFiles files;
  Workspace workspace;
  RunOutcome outcome;
  Clock::time_point start = Clock::now(), last_line = start;
  double stage_start = 0;
  bool has_moved = false;

  Progress(const Scene& s, const std::string& directory) : scene(s), files(s, directory) {}
};

void account(Progress& run, const char* part, Clock::time_point start) {
  run.outcome.facts.timing[part] += seconds_since(start);
}

/// Time that all stages up to the present moment can take, and in all, s.
double share_done(const Progress& run) {
  double total = 0, done = run.outcome.state.stage_time;
  for (std::size_t i = 0; i < run.scene.stages.size(); ++i) {
    total += run.scene.stages[i].duration;
    if (static_cast<Index>(i) < run.outcome.state.stage) done += run.scene.stages[i].duration;
  }
  return done / total;
}

void print_progress(Progress& run, const StepReport& report) {
  if (seconds_since(run.last_line) < 1) return;
  run.last_line = Clock::now();
  const State& state = run.outcome.state;
  const double share = share_done(run), wall = seconds_since(run.start);
  fmt::print("  {:<10} t {:8.4f} s  step {:5}  dt {:.2e} s  {:3.0f} %  about {:.0f} s left\n",
             run.scene.stages[state.stage].name, state.time, state.totals.steps, report.dt, 100 * share,
             wall * (1 - share) / std::max(share, 1e-3));
  std::fflush(stdout);
}

void write_fields(Progress& run, const StepReport& report) {
  const auto start = Clock::now();
  run.files.fields(run.outcome.state, report);
  account(run, "output", start);
}

void save(Progress& run) {
  const auto start = Clock::now();
  write_checkpoint(run.files.directory() + "/checkpoint.h5", run.scene, run.outcome.state);
  account(run, "output", start);
}

/// A new glass mesh for the present state; false when none could be made and the old one cannot go on.
bool renew(Progress& run, bool must) {
  const auto start = Clock::now();
  auto renewed = renew_glass_mesh(run.scene, run.outcome.state);
  account(run, "remesh", start);
  if (renewed.ok) {
    run.outcome.state = std::move(renewed.state);
    run.workspace.flow.reset();
    return true;
  }
  const std::string sentence = fmt::format("no new glass mesh: {}", renewed.reason);
  auto& reason = run.outcome.facts.reason;
  if (must) reason = reason.empty() ? sentence : reason + "; " + sentence;
  return !must;
}

/// A step that converged and kept within its allowance; false when the smallest one did not.
bool step_once(Progress& run, StepReport& report) {
  State& state = run.outcome.state;
  for (double dt = landing_step(run.scene, state, state.next_step);;) {
    auto result = coupled_step(run.scene, state, dt, run.workspace);
    for (const auto& [part, seconds] : result.report.seconds) run.outcome.facts.timing[part] += seconds;
    if (result.converged && !overshot(run.scene, result.report)) {
      result.state.next_step = wished_step(run.scene, result.report, state.next_step);
      state = std::move(result.state);
      report = std::move(result.report);
      return true;
    }
    ++state.totals.rejected;
    run.workspace.standing.reset();
    run.outcome.facts.reason = result.converged ? "the step deforms the glass too much" : result.reason;
    dt = result.converged ? std::max(shorten * dt, wished_step(run.scene, result.report, dt)) : shorten * dt;
    if (dt < run.scene.accuracy.smallest_step) return false;
    state.next_step = dt;
  }
}

/// A tool deeper than this in the glass at a stage's start is an error of the scene, m.
constexpr double most_overlap = 0.5e-3;

/// What makes the stage impossible from where the tools and the glass stand; empty when nothing does.
std::string stage_obstacle(const Scene& scene, const State& state) {
  for (const auto& place : scene.stages[state.stage].tools) {
    const auto* position = std::get_if<PositionMotion>(&place.motion);
    const double now = state.bodies[1 + place.tool].offset;
    if (position && std::abs(position->offset(0) - now) > 1e-6)
      return fmt::format("tool {} stands at {:.4g} mm, its motion starts at {:.4g} mm", scene.tools[place.tool].name,
                         1e3 * now, 1e3 * position->offset(0));
  }
  const double overlap = deepest_penetration(scene, state);
  if (overlap > most_overlap) return fmt::format("a tool in place overlaps the glass by {:.3g} mm", 1e3 * overlap);
  return "";
}

/// Enters a stage; false when it cannot begin.
bool begin_stage(Progress& run, Index stage) {
  State& state = run.outcome.state;
  state = start_stage(run.scene, state, stage);
  state.next_step = run.scene.accuracy.first_step;
  run.stage_start = state.time;
  run.has_moved = false;
  run.outcome.facts.reason = stage_obstacle(run.scene, state);
  return run.outcome.facts.reason.empty();
}

void end_stage(Progress& run, bool good) {
  const State& state = run.outcome.state;
  const Stage& stage = run.scene.stages[state.stage];
  const bool full = state.stage_time >= stage.duration - 1e-9;
  run.outcome.facts.stages.push_back(
      {stage.name, run.stage_start, state.time, !good ? "failure" : full ? "duration" : "tools at rest"});
}

bool advance_stage(Progress& run) {
  State& state = run.outcome.state;
  const Scene& scene = run.scene;
  StepReport report;
  while (!stage_over(scene, state, run.has_moved)) {
    if (scene.has_flow() && needs_new_mesh(scene, state) && !renew(run, false)) return false;
    if (!step_once(run, report)) {
      // A mesh that is still sound may be what holds the step back.
      if (!scene.has_flow() || !renew(run, true) || !step_once(run, report)) return false;
    }
    for (const auto& tool : scene.stages[state.stage].tools)
      if (scene.stages[state.stage].end_speed &&
          std::abs(state.bodies[1 + tool.tool].velocity) > *scene.stages[state.stage].end_speed)
        run.has_moved = true;
    const auto start = Clock::now();
    run.files.row(history_row(scene, state, report));
    account(run, "output", start);
    if (output_due(scene, state)) write_fields(run, report);
    print_progress(run, report);
  }
  write_fields(run, report);
  return true;
}

/// Interfaces over which no heat went in the whole run; bodies that start at one temperature say nothing.
void warn_of_unused_interfaces(Progress& run) {
  const Scene& scene = run.scene;
  for (const Interface& interface : scene.interfaces) {
    const Tool& tool = scene.tools[interface.tool];
    if (run.outcome.state.bodies[1 + interface.tool].heat_received == 0 &&
        tool.initial_temperature != scene.glass.initial_temperature)
      run.outcome.facts.warnings.push_back(fmt::format(
          "the interface of the glass with {} was never used: in the whole run they did not come within {:.4g} mm of each "
          "other",
          tool.name, 1e3 * interface.handover_width));
  }
}

void warn(Progress& run) {
  const Totals& totals = run.outcome.state.totals;
  auto& warnings = run.outcome.facts.warnings;
  if (totals.largest_reynolds > 1)
    warnings.push_back(fmt::format("inertia was left out, but the Reynolds number reached {:.2g}", totals.largest_reynolds));
  if (totals.table_holds > 0)
    warnings.push_back(fmt::format("a conductance table was asked {} times outside its range", totals.table_holds));
}

}  // namespace

RunOutcome run(const Scene& scene, const std::string& directory) {
  Progress run(scene, directory);
  run.outcome.state = initial_state(scene);
  auto& facts = run.outcome.facts;
  bool good = true;
  for (Index stage = 0; good && stage < static_cast<Index>(scene.stages.size()); ++stage) {
    good = begin_stage(run, stage);
    if (stage == 0) write_fields(run, {});
    if (good && stage > 0 && scene.has_flow()) good = renew(run, false);
    good = good && advance_stage(run);
    if (!good) write_fields(run, {});
    end_stage(run, good);
    save(run);
  }
  facts.completed = good;
  if (good) facts.reason.clear();
  else
    facts.reason = fmt::format("stage {} at {:.5f} s: {}", scene.stages[run.outcome.state.stage].name,
                               run.outcome.state.time, facts.reason);
  warn(run);
  if (good) warn_of_unused_interfaces(run);
  facts.wall_seconds = seconds_since(run.start);
  return std::move(run.outcome);
}

}  // namespace parison::forming
