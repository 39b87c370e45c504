// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/run/console.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>

#include "core/process/clock.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::tools {
void Console::run_begins(const forming::RunView& run) {
  start_ = last_line_ = core::wall_seconds();
  remaining_.run_begins(run);
  const forming::State& state = run.state;
  if (state.totals.steps > 0)
    fmt::print("  {:<10} t {:8.4f} s  step {:5}  {} remeshes so far\n", run.scene.stages[state.stage].name, state.time,
               state.totals.steps, remeshes(state));
}

void Console::stage_begins(const forming::RunView& run) {
  remaining_.stage_begins(run);
}

void Console::step_taken(const forming::RunView& run, const forming::State&, const forming::StepReport& report) {
  print_line(run, report.dt);
}

void Console::solid_step_taken(const forming::RunView& run, const forming::SolidState& solid) {
  print_line(run, solid.last_step);
}

void Console::print_line(const forming::RunView& run, double step) {
  const double now = core::wall_seconds();
  if (now - last_line_ < 1) return;
  last_line_ = now;
  const double fraction = remaining_.fraction_done(run);
  shown_ = std::max(shown_, fraction);
  fmt::print("  {:<10} t {:8.4f} s  step {:5}  dt {:.2e} s  {:3.0f} %  about {:.0f} s left\n",
             run.scene.stages[run.state.stage].name, run.state.time, run.state.totals.steps, step, 100 * shown_,
             (now - start_) * (1 - fraction) / std::max(fraction, 1e-3));
  std::fflush(stdout);
}

}  // namespace parison::tools
