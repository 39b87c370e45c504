#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// The air in the sealed cavities of a state, a value for each cavity in their order along the glass.
struct CavityReport {
  std::vector<double> volume;    ///< m3
  std::vector<double> pressure;  ///< absolute, Pa
  std::vector<double> mass;      ///< kg

  std::size_t size() const { return volume.size(); }
};
CavityReport cavity_report(const Scene& scene, const State& state);

/// Whether any stage of a scene seals cavities.
bool seals_cavities(const Scene& scene);

}  // namespace parison::forming
