#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The state of the glass as one looks at it: volume, mass, heat.
struct GlassFacts {
  double volume;                 ///< m3
  double mass;                   ///< kg
  double mean, lowest, highest;  ///< temperature, K; NaN without heat
  double volume_drift;           ///< relative to the start, remeshing included
  double
      energy_imbalance;  ///< what the heat given off does not explain, relative to it; remeshing counts as unexplained
};
GlassFacts glass_facts(const Scene& scene, const State& state);

/// A row of history.csv.
HistoryRow history_row(const Scene& scene, const State& state, const StepReport& report);

/// Line of column names of history.csv, and a row as a line.
std::string history_header(const Scene& scene);
std::string history_line(const HistoryRow& row);

}  // namespace parison::forming
