#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "forming/report/cavity_report.hpp"
#include "forming/report/process/mould_filling.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/step_result.hpp"

namespace parison::forming {

/// Quantities of the glass derived from its state: volume, mass, heat.
struct GlassFacts {
  double volume;                 ///< m3
  double mass;                   ///< kg
  double mean, lowest, highest;  ///< temperature, K; NaN without heat
  double volume_drift;           ///< relative to the start, remeshing included
  double energy_imbalance;  ///< change of heat content that the heat given off does not explain, relative to that heat;
                            ///< includes changes by remeshing
};
GlassFacts glass_facts(const Scene& scene, const State& state);

/// Change of a tool's heat content since the start that the heat received from the glass and given off through its
/// boundaries does not explain, relative to the heat that the glass has lost. The tool must carry heat.
double energy_imbalance(const Scene& scene, const State& state, Index tool);

/// The numbers of one row of history.csv.
struct HistoryRow {
  double time, dt, volume, glass_mean, heat_to_tools, heat_to_air, dissipation, energy_imbalance, contact_area;
  GlassShape shape;                                       ///< of the glass at the end of the step
  double sag = std::numeric_limits<double>::quiet_NaN();  ///< of its lowest point since the stage's start, m
  std::string stage;
  std::vector<double> tool_force, tool_position, tool_speed, probe;  ///< N, m, m/s, K
  Index coupling_iterations, flow_solves, contact_changes, heat_substeps;
  std::string limited_by;
  std::optional<CavityReport> cavities;  ///< where a stage of the scene seals cavities
};

/// The row of a step that ended with `state`: time, places and forces are those of its end.
HistoryRow history_row(const Scene& scene, const State& state, const StepReport& report);

/// Line of column names of history.csv, and a row as a line.
std::string history_header(const Scene& scene);
std::string history_line(const HistoryRow& row);

}  // namespace parison::forming
