// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/light_samples.hpp"

#include "forming/step/heat/heat_step.hpp"

namespace parison::forming {

void follow_light(const Scene& scene, const State& before, const StepResult& step, LightSamples& samples) {
  constexpr Index seldom = 90;
  if (!(scene.has_light() || scene.enclosure) || before.totals.steps % seldom != 0) return;
  const thermal::LightError error = light_error(scene, step.at_heat, step.report.interface);
  samples.heat += step.report.dt * error.all_heat;
  samples.uncertain += step.report.dt * error.power;
}

}  // namespace parison::forming
