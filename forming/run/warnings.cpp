// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/warnings.hpp"

#include <fmt/core.h>

#include <cmath>

namespace parison::forming {

Warnings moving_tool_warnings(const Scene& scene, const State& state) {
  Warnings warnings;
  const Stage& stage = scene.stages[state.stage];
  for (const StageTool& tool : stage.tools) {
    const double speed = std::abs(state.tools[tool.tool].velocity);
    if (stage.end_speed && std::holds_alternative<ForceMotion>(tool.motion) && speed >= *stage.end_speed)
      warnings.push_back(fmt::format(
          "stage {} ended by its duration of {:g} s while {} still moved at {:.3g} mm/s, above its end_speed of {:g} "
          "mm/s: a longer duration lets it come to rest, less force or a higher end_speed ends the stage before",
          stage.name, stage.duration, scene.tools[tool.tool].name, 1e3 * speed, 1e3 * *stage.end_speed));
  }
  return warnings;
}

Warnings remeshing_warnings(const State& state) {
  Warnings warnings;
  const RemeshStatistics& remeshing = state.totals.remeshing;
  if (remeshing.laps > 0)
    warnings.push_back(fmt::format(
        "the glass folded onto itself at {} points. The folds were closed and enclose {:.2g} mm3 of air; the container "
        "would show fold marks (laps) there. A hotter gob, a slower plunger or less friction keeps the surface apart; "
        "the "
        "VTU files show where",
        remeshing.laps, 1e9 * remeshing.lap_volume));
  if (remeshing.torn > 0)
    warnings.push_back(fmt::format(
        "{} pieces of glass, {:.2g} mm3, tore off where the glass had thinned to nothing. Their glass was given to the "
        "rest; on a machine they would stay on a tool. Less friction or a hotter tool there lets the glass slide",
        remeshing.torn, 1e9 * remeshing.torn_volume));
  return warnings;
}

Warnings unused_interface_warnings(const Scene& scene, const State& state) {
  Warnings warnings;
  for (const Interface& interface : scene.interfaces) {
    const Tool& tool = scene.tools[interface.tool];
    if (state.tools[interface.tool].heat_received == 0 && tool.initial_temperature != scene.glass.initial_temperature)
      warnings.push_back(fmt::format(
          "the interface of the glass with {} was never used: during the whole run they stayed farther apart than "
          "{:.4g} mm. Leave it out of the case, or look whether the tool is where it should be: `parison check "
          "--picture`",
          tool.name, 1e3 * interface.transition_gap));
  }
  return warnings;
}

void add_warnings(const Warnings& warnings, RunFacts& facts) {
  facts.warnings.insert(facts.warnings.end(), warnings.begin(), warnings.end());
}

}  // namespace parison::forming
