#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "core/io/json.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// A number with so many decimals, and with more where they would leave a small one fewer than four figures.
inline std::string figures(double value, int decimals) {
  const int whole = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
  return fmt::format("{:.{}f}", value, std::max(decimals, 4 - whole));
}

/// Height of a container and its largest outer diameter, m.
struct OuterSize {
  double height = 0, diameter = 0;
};

/// The container at 20 degC, where the density of the glass depends on temperature.
struct ColdContainer {
  OuterSize size;
  double contraction;              ///< of the glass in length since the end of the run, mean: what a mould is larger by
  std::optional<double> capacity;  ///< to the rim, m3
  std::optional<double> filled;    ///< to the fill level of the case, m3
};

/// The container as the run has formed it.
struct ContainerReport {
  double weight = 0;  ///< kg
  double rim =
      std::numeric_limits<double>::quiet_NaN();  ///< where it runs over, or its highest place, m along the axis
  OuterSize size;                                ///< at the end of the run
  std::optional<double> capacity;                ///< to the rim, m3; none where the glass holds nothing
  std::string absent;                            ///< why there is no capacity, a sentence; empty with one
  std::optional<double> to_drawn_rim;            ///< m3, as if the rim were where the drawings have it
  std::optional<double> filled;                  ///< to the fill level of the case, m3
  std::optional<double> plunger_stop;            ///< offset of the plunger of the press, where a force drives it, m
  std::optional<ColdContainer> cold;
};

/// Nothing in a planar scene, without flow or without tools, and where neither the drawings make a container
/// (container_plan) nor the glass is a wall. It stands upright in the last stage, as gravity says.
std::optional<ContainerReport> container_report(const Scene& scene, const State& state, bool is_wall);

/// The object `container` of summary.json, with what the drawings said; nothing without a report.
void add_container(core::JsonWriter& json, const Scene& scene, const State& state, bool is_wall);

/// Capacity for the table of results, or why there is none; empty without a report.
std::string capacity_text(const Scene& scene, const State& state, bool is_wall);

}  // namespace parison::forming
