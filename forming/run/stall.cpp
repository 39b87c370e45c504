// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/stall.hpp"

#include <fmt/core.h>

namespace parison::forming {
namespace {

/// That glass has come deep into a tool through a face that cannot keep it out; the face is told at the end of any run.
std::string deep_in_tool(const GlassInTools& seen) {
  constexpr double severe = 0.1;  // of the mean wall, as of the check of penetration
  if (seen.entered_tool < 0 || seen.node.share < severe) return "";
  return fmt::format("glass is inside the tool by {:.0f} % of its mean wall", 100 * seen.node.share);
}

}  // namespace

std::string StallWatch::reason(const Scene& scene, const State& state, const Diagnostics& seen) {
  constexpr Index counted = 150;  // steps
  constexpr double short_share = 0.9, many = 1e4;
  if (const std::string deep = deep_in_tool(seen.in_tools); !deep.empty()) return deep;
  const Start now{state.totals.steps, seen.steps.short_steps, state.stage_time}, before = start_.value_or(now);
  const Index steps = now.steps - before.steps;
  if (!start_ || steps >= counted) start_ = now;
  if (steps < counted) return "";
  const double left = scene.stages[static_cast<std::size_t>(state.stage)].duration - now.time;
  const double to_come = steps * left / (now.time - before.time);
  if (now.short_steps - before.short_steps < short_share * steps || to_come < many) return "";
  return fmt::format(
      "the last {} steps, of {:.2g} s on average, were about as short as numerics.min_step = {:g} s, and the rest of "
      "the "
      "stage would take {:.1g} more like them: the motion is faster there than any forming, as of a bursting film or "
      "of a "
      "tool that is not balanced; look at the last pictures",
      steps, (now.time - before.time) / steps, scene.accuracy.min_step, to_come);
}

}  // namespace parison::forming
