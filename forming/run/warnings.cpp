// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/warnings.hpp"

#include <fmt/core.h>

#include <cmath>

#include "forming/report/summary_parts.hpp"

namespace parison::forming {

namespace {

/// Largest overshoot of a temperature without a warning, of the span of the scene's temperatures.
constexpr double overshoot_limit = 0.1;
/// Largest imbalance of the mechanical work without a warning, relative.
constexpr double work_imbalance_limit = 1e-3;
/// Most contacts that were kept closed although they pull without a warning, for each step.
constexpr double locked_limit = 0.1;

void warn_of_remeshing(const Scene& scene, const RemeshStatistics& remeshing, Warnings& warnings) {
  if (remeshing.failed > 1) warnings.push_back(fmt::format("{} new glass meshes could not be made", remeshing.failed));
  if (remeshing.laps > 0)
    warnings.push_back(fmt::format(
        "the glass folded onto itself at {} points. The folds were closed and enclose {:.2g} mm3 of air; the container "
        "would show fold marks (laps) there",
        remeshing.laps, 1e9 * remeshing.lap_volume));
  if (remeshing.torn > 0)
    warnings.push_back(fmt::format(
        "{} pieces of glass, {:.2g} mm3, tore off where the glass had thinned to nothing. Their glass was given to the "
        "rest; on a machine they would stay on a tool. Less friction or a hotter tool there lets the glass slide",
        remeshing.torn, 1e9 * remeshing.torn_volume));
  if (remeshing.coarsening_factor > 1)
    warnings.push_back(fmt::format("a glass mesh was {:.3g} times coarser than asked for, to have about {:g} cells",
                                   remeshing.coarsening_factor, scene.accuracy.max_cells));
}

}  // namespace

Warnings moving_tool_warnings(const Scene& scene, const State& state) {
  Warnings warnings;
  const Stage& stage = scene.stages[state.stage];
  for (const StageTool& tool : stage.tools) {
    const double speed = std::abs(state.tools[tool.tool].velocity);
    if (stage.end_speed && std::holds_alternative<ForceMotion>(tool.motion) && speed >= *stage.end_speed)
      warnings.push_back(fmt::format(
          "stage {} ended by its duration of {:g} s while {} still moved at {:.3g} mm/s, above its end_speed of {:g} "
          "mm/s",
          stage.name, stage.duration, scene.tools[tool.tool].name, 1e3 * speed, 1e3 * *stage.end_speed));
  }
  return warnings;
}

Warnings accuracy_warnings(const Scene& scene, const State& state, const RunFacts& facts) {
  Warnings warnings;
  const Totals& totals = state.totals;
  if (totals.max_reynolds > 1)
    warnings.push_back(
        fmt::format("inertia is neglected, but the Reynolds number reached {:.2g}", totals.max_reynolds));
  warn_of_remeshing(scene, totals.remeshing, warnings);
  if (const double imbalance = max_work_imbalance(facts); imbalance > work_imbalance_limit)
    warnings.push_back(fmt::format(
        "the work done on the glass and the work dissipated or stored differ by {:.2g} % at a stage's end; a higher "
        "accuracy or a smaller numerics.strain_per_step helps",
        100 * imbalance));
  if (totals.clamped_lookups > 0)
    warnings.push_back(fmt::format("{} look-ups of a conductance table were outside its range and were clamped",
                                   totals.clamped_lookups));
  if (const double span = temperature_range(scene).span(); totals.overshoot > overshoot_limit * span)
    warnings.push_back(fmt::format(
        "a temperature overshot the highest initial or boundary temperature by {:.0f} K, {:.2g} % of their range: "
        "thermal boundary layers are thinner than the mesh resolves; a smaller numerics.skin_size helps",
        totals.overshoot, 100 * totals.overshoot / span));
  if (const long locked = facts.solver_statistics.locked_contacts;
      static_cast<double>(locked) > locked_limit * totals.steps)
    warnings.push_back(fmt::format(
        "{} contacts, summed over all steps, were locked although in tension, because the active set cycled", locked));
  return warnings;
}

Warnings unused_interface_warnings(const Scene& scene, const State& state) {
  Warnings warnings;
  for (const Interface& interface : scene.interfaces) {
    const Tool& tool = scene.tools[interface.tool];
    if (state.tools[interface.tool].heat_received == 0 && tool.initial_temperature != scene.glass.initial_temperature)
      warnings.push_back(fmt::format(
          "the interface of the glass with {} was never used: during the whole run they stayed farther apart than "
          "{:.4g} mm",
          tool.name, 1e3 * interface.transition_gap));
  }
  return warnings;
}

void add_warnings(const Warnings& warnings, RunFacts& facts) {
  facts.warnings.insert(facts.warnings.end(), warnings.begin(), warnings.end());
}

}  // namespace parison::forming
