// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/warnings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace parison::forming {

namespace {

bool touches_glass(const State& state, Index tool) {
  const std::vector<Index>& touched = state.glass.contact_tool;
  return std::find(touched.begin(), touched.end(), tool) != touched.end();
}

/// What a tool that still moves at the end of its stage asks for.
std::string advice_for_moving_tool(const std::string& tool, bool is_touching) {
  if (is_touching)
    return "it has not finished its stroke. A longer duration or more force lets it come to rest against the glass";
  return fmt::format(
      "it touches no glass. If it moved away from the glass, turn the sign of motion.{}.force (positive is along "
      "+axis); "
      "if it has not reached the glass yet, it needs a longer duration or a start nearer to the glass",
      tool);
}

}  // namespace

Warnings moving_tool_warnings(const Scene& scene, const State& state) {
  Warnings warnings;
  const Stage& stage = scene.stages[state.stage];
  if (!stage.end_speed) return warnings;
  for (const StageTool& tool : stage.tools) {
    const auto* motion = std::get_if<ForceMotion>(&tool.motion);
    if (!motion) continue;
    const std::string& name = scene.tools[tool.tool].name;
    const double speed = std::abs(state.tools[tool.tool].velocity);
    if (speed >= *stage.end_speed)
      warnings.push_back(fmt::format(
          "stage {} ended by its duration of {:g} s while {} still moved at {:.3g} mm/s, above its end_speed of {:g} "
          "mm/s: {}",
          stage.name, stage.duration, name, 1e3 * speed, 1e3 * *stage.end_speed,
          advice_for_moving_tool(name, touches_glass(state, tool.tool))));
    else if (!state.has_moved)
      warnings.push_back(fmt::format(
          "stage {} ended by its duration of {:g} s, and {} never moved faster than its end_speed of {:g} mm/s: a "
          "force of up to {:.4g} N hardly moves it, and the glass may not be pressed to its shape. More force or "
          "hotter glass moves it; where it should creep, a lower end_speed lets the stage end by it",
          stage.name, stage.duration, name, 1e3 * *stage.end_speed, motion->force.max_size()));
  }
  return warnings;
}

Warnings remeshing_warnings(const State& state) {
  Warnings warnings;
  const RemeshStatistics& remeshing = state.totals.remeshing;
  if (remeshing.laps > 0)
    warnings.push_back(fmt::format(
        "the glass folded onto itself at {}. {} closed and {} {:.2g} mm3 of air; the container would show fold marks "
        "(laps) there. A hotter gob, a slower plunger or less friction keeps the surface apart; the VTU files show "
        "where",
        remeshing.laps == 1 ? "one point" : fmt::format("{} points", remeshing.laps),
        remeshing.laps == 1 ? "The fold was" : "The folds were", remeshing.laps == 1 ? "encloses" : "enclose",
        1e9 * remeshing.lap_volume));
  if (remeshing.torn > 0)
    warnings.push_back(fmt::format(
        "{}, {:.2g} mm3, tore off where the glass had thinned to nothing. That glass was given to the rest; on a "
        "machine it would stay on a tool. Less friction or a hotter tool there lets the glass slide",
        remeshing.torn == 1 ? "one piece of glass" : fmt::format("{} pieces of glass", remeshing.torn),
        1e9 * remeshing.torn_volume));
  return warnings;
}

Warnings unused_interface_warnings(const Scene& scene, const State& state) {
  Warnings warnings;
  for (const Interface& interface : scene.interfaces) {
    const Tool& tool = scene.tools[interface.tool];
    if (state.tools[interface.tool].heat_received == 0 && tool.initial_temperature != scene.glass.initial_temperature)
      warnings.push_back(fmt::format(
          "the glass never reached {0}: during the whole run they stayed farther apart than {1:.4g} mm, and no heat "
          "passed between them. Where it should reach it, the glass was too cold or too little, or was not pressed or "
          "blown far enough, or the tool is not where it should be (`parison check --picture` draws it)",
          tool.name, 1e3 * interface.transition_gap));
  }
  return warnings;
}

void add_warnings(const Warnings& warnings, RunFacts& facts) {
  facts.warnings.insert(facts.warnings.end(), warnings.begin(), warnings.end());
}

}  // namespace parison::forming
