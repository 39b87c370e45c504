// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/step_start.hpp"

#include <algorithm>

#include "forming/step/cavities/trapped_air.hpp"
#include "forming/step/contact/film.hpp"

namespace parison::forming {

StepStart step_start(const Scene& scene, const State& state, double dt) {
  StepStart start{scene, state, dt, {}, {}, 0, {}, {}};
  if (!scene.has_flow()) return start;
  start.frozen = frozen_cells(scene, state);
  start.penetrations = penetrations(scene, state, 0);
  if (scene.stages[state.stage].trapped_air) seal_air(start);
  for (const auto& inside : start.penetrations) start.max_penetration = std::max(start.max_penetration, inside.depth);
  return start;
}

}  // namespace parison::forming
