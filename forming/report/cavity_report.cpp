// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/cavity_report.hpp"

#include <algorithm>

#include "forming/step/cavities/trapped_air.hpp"

namespace parison::forming {

CavityReport cavity_report(const Scene& scene, const State& state) {
  CavityReport report;
  const auto& law = scene.stages[state.stage].trapped_air;
  if (!law) return report;
  const CavityAir& air = state.cavity_air;
  report.volume = air.volume;
  for (std::size_t i = 0; i < air.volume.size(); ++i) {
    report.pressure.push_back(air.energy[i] / air.volume[i]);
    report.mass.push_back(air.amount[i] / (gas_constant_of_air * law->temperature));
  }
  return report;
}

bool seals_cavities(const Scene& scene) {
  return std::any_of(scene.stages.begin(), scene.stages.end(),
                     [](const Stage& stage) { return stage.trapped_air.has_value(); });
}

}  // namespace parison::forming
