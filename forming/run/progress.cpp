// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/progress.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <ctime>

#include "forming/step/step_control.hpp"
#include "forming/step/thermal_interface.hpp"

namespace parison::forming {

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void account(Progress& run, const char* part, Clock::time_point start) {
  run.outcome.facts.timing[part] += seconds_since(start);
}

double cpu_seconds_of_process() {
  return double(std::clock()) / CLOCKS_PER_SEC;
}

void update_times(Progress& run) {
  run.outcome.facts.wall_seconds = run.wall_before + seconds_since(run.start);
  run.outcome.facts.cpu_seconds = run.cpu_before + cpu_seconds_of_process() - run.cpu_start;
}

double fraction_done(const Progress& run) {
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
  const double fraction = fraction_done(run), wall = seconds_since(run.start);
  fmt::print("  {:<10} t {:8.4f} s  step {:5}  dt {:.2e} s  {:3.0f} %  about {:.0f} s left\n",
             run.scene.stages[state.stage].name, state.time, state.totals.steps, report.dt, 100 * fraction,
             wall * (1 - fraction) / std::max(fraction - run.fraction_before, 1e-3));
  std::fflush(stdout);
}

void write_fields(Progress& run, const State& state) {
  const auto start = Clock::now();
  run.files.fields(state,
                   run.scene.has_heat() ? thermal_interface(run.scene, state) : std::vector<core::InterfacePoint>{});
  account(run, "output", start);
}

void save(Progress& run) {
  const State& state = run.outcome.state;
  const auto& static_stage = run.workspace.static_stage;
  const bool in_integrator = static_stage && !static_stage->expired && !stage_over(run.scene, state, state.has_moved);
  if (in_integrator || state.totals.steps == run.checkpoint_steps) return;
  const auto start = Clock::now();
  update_times(run);
  write_checkpoint(run.files.directory(), run.scene, {run.outcome, run.files.sync()});
  run.last_checkpoint = Clock::now();
  run.checkpoint_steps = state.totals.steps;
  account(run, "output", start);
}

void save_when_due(Progress& run) {
  const Output& output = run.scene.output;
  const Index steps = run.outcome.state.totals.steps - run.checkpoint_steps;
  if (seconds_since(run.last_checkpoint) >= output.checkpoint_interval ||
      (output.checkpoint_steps && steps >= *output.checkpoint_steps))
    save(run);
}

}  // namespace parison::forming
