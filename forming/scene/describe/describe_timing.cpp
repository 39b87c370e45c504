// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/describe_timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace parison::forming {
namespace {

std::string stage_rows(const Scene& scene) {
  const double degrees = 360 / scene.timing->cycle;  // in a second
  std::string text = fmt::format("  {:<20}{:<18}{:<20}{}\n", "", "deg", "s", "ends at");
  double time = 0;
  for (const Stage& stage : scene.stages) {
    const double end = time + stage.duration;
    const std::string seconds = fmt::format("{:.4g} to {:.4g}", time, end);
    std::string angles = "-";
    if (stage.timed) {
      const double from = std::fmod(stage.timed->from, 360.0);
      angles = fmt::format("{:.4g} to {:.4g}", from, std::fmod(stage.timed->from + stage.duration * degrees, 360.0));
    }
    const bool at_event = stage.timed && !stage.timed->until_event.empty();
    text += fmt::format("  {:<20}{:<18}{:<20}{}\n", stage.name, angles, seconds,
                        at_event ? stage.timed->until_event : "its duration");
    time = end;
  }
  return text;
}

/// From the first stage in which a tool is active to the end of the last.
std::string tool_rows(const Scene& scene) {
  std::string text;
  for (Index tool = 0; tool < static_cast<Index>(scene.tools.size()); ++tool) {
    double time = 0, first = -1, last = 0;
    for (const Stage& stage : scene.stages) {
      const bool active = std::any_of(stage.tools.begin(), stage.tools.end(),
                                      [&](const StageTool& entry) { return entry.tool == tool; });
      if (active && first < 0) first = time;
      time += stage.duration;
      if (active) last = time;
    }
    if (first < 0) continue;
    const double share = (last - first) / scene.timing->cycle;
    text +=
        fmt::format("  {:<20}in use for {:.4g} deg, {:.0f} % of the cycle{}\n", scene.tools[tool].name, 360 * share,
                    100 * share, share > 1 ? ": longer than a cycle, so that a second one takes turns with it" : "");
  }
  return text;
}

}  // namespace

std::string describe_timing(const Scene& scene) {
  if (!scene.timing) return "";
  const Timing& timing = *scene.timing;
  return fmt::format("\ntiming                {:.4g} cuts a minute, {} section{}: a cycle of {:.4g} s, {:.4g} deg/s\n",
                     60 * timing.cuts, timing.sections, timing.sections == 1 ? "" : "s", timing.cycle,
                     360 / timing.cycle) +
         stage_rows(scene) + tool_rows(scene);
}

}  // namespace parison::forming
