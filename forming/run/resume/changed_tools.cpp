// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/resume/changed_tools.hpp"

#include <fmt/format.h>

#include "core/process/run_error.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/tool_surface.hpp"
#include "forming/step/idle/idle_tools.hpp"

namespace parison::forming {
namespace {

/// All tools as they would be at the time of a run's state had no glass touched any since the start.
State idle_since_start(const Scene& scene, const RunOutcome& run) {
  State idle = initial_state(scene);
  if (!scene.has_heat()) return idle;
  for (; idle.stage <= run.state.stage; ++idle.stage) {
    const auto stage = static_cast<std::size_t>(idle.stage);
    const bool has_ended = stage < run.facts.stages.size();
    idle.stage_start = idle.time;
    const double end = has_ended ? run.facts.stages[stage].end : run.state.time;
    if (const std::string reason = idle_tools(scene, idle, end - idle.time); !reason.empty())
      throw core::RunError(
          fmt::format("tools that were not used yet, in stage {}: {}", scene.stages[stage].name, reason));
    idle.time = end;
  }
  return idle;
}

/// The hotter of a tool's surface at the start and now.
Extreme hottest_of(const ToolState& start, const ToolState& now, double time) {
  const HottestPoint first = hottest_surface_point(start), last = hottest_surface_point(now);
  Extreme hottest;
  const bool is_last = last.temperature > first.temperature;
  hottest.temperature = is_last ? last.temperature : first.temperature;
  hottest.time = is_last ? time : 0;
  hottest.at = is_last ? last.at : first.at;
  return hottest;
}

}  // namespace

void renew_unused_tools(const Scene& scene, const std::vector<Index>& tools, RunOutcome& outcome) {
  if (tools.empty()) return;
  const State start = initial_state(scene), idle = idle_since_start(scene, outcome);
  for (const Index tool : tools) {
    const auto t = static_cast<std::size_t>(tool);
    outcome.state.tools[t] = idle.tools[t];
    if (scene.has_heat())
      outcome.facts.diagnostics.extremes.tools[t] = hottest_of(start.tools[t], idle.tools[t], outcome.state.time);
  }
}

}  // namespace parison::forming
