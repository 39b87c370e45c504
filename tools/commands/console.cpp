// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/console.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>

#include "core/process/clock.hpp"

namespace parison::tools {
namespace {

/// Simulated time that is done, of the longest that all stages can take.
double fraction_done(const forming::RunView& run) {
  double total = 0, done = run.state.stage_time;
  for (std::size_t i = 0; i < run.scene.stages.size(); ++i) {
    total += run.scene.stages[i].duration;
    if (static_cast<forming::Index>(i) < run.state.stage) done += run.scene.stages[i].duration;
  }
  return done / total;
}

}  // namespace

void Console::run_begins(const forming::RunView& run) {
  start_ = last_line_ = core::wall_seconds();
  fraction_before_ = fraction_done(run);
  const forming::State& state = run.state;
  if (state.totals.steps > 0)
    fmt::print("  {:<10} t {:8.4f} s  step {:5}  {} remeshes so far\n", run.scene.stages[state.stage].name, state.time,
               state.totals.steps, remeshes(state));
}

void Console::step_taken(const forming::RunView& run, const forming::State&, const forming::StepReport& report) {
  const double now = core::wall_seconds();
  if (now - last_line_ < 1) return;
  last_line_ = now;
  const double fraction = fraction_done(run);
  fmt::print("  {:<10} t {:8.4f} s  step {:5}  dt {:.2e} s  {:3.0f} %  about {:.0f} s left\n",
             run.scene.stages[run.state.stage].name, run.state.time, run.state.totals.steps, report.dt, 100 * fraction,
             (now - start_) * (1 - fraction) / std::max(fraction - fraction_before_, 1e-3));
  std::fflush(stdout);
}

}  // namespace parison::tools
