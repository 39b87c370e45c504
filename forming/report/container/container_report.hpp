#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include "core/io/json.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The container as the run has formed it.
struct ContainerReport {
  double weight = 0;                   ///< kg
  double rim = 0;                      ///< highest place of the glass as it stands, m along the axis
  std::optional<double> capacity;      ///< to the rim, m3; none where the glass holds nothing
  std::optional<double> filled;        ///< to the fill level of the case, m3
  std::optional<double> plunger_stop;  ///< offset of the plunger of the press, where a force drives it, m
};

/// Nothing where the drawings make no container (container_plan), or where gravity does not say how it stands. It
/// stands upright in the last stage.
std::optional<ContainerReport> container_report(const Scene& scene, const State& state);

/// The object `container` of summary.json, with what the drawings said; nothing without a report.
void add_container(core::JsonWriter& json, const Scene& scene, const State& state);

/// Capacity for the table of results, empty without one.
std::string capacity_text(const Scene& scene, const State& state);

}  // namespace parison::forming
