// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/describe/half_spaces.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/erfcx.hpp"
#include "forming/scene/describe/model_sensitivity.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

double effusivity(const thermal::Material& material, double temperature, double conductivity) {
  return std::sqrt(conductivity * material.density * material.heat_capacity(temperature));
}

/// Heat over 1 K that two half-spaces exchange through h in a time, over h, s; `resistance` is the sum of 1 over their
/// effusivities.
double exchanged(double h, double resistance, double time) {
  const double H = h * resistance, x = H * std::sqrt(time);
  if (x < 1e-3) return time * (1 - 4 * x / (3 * std::sqrt(M_PI)));  // else cancelled away
  return (core::erfcx(x) - 1 + 2 * x / std::sqrt(M_PI)) / (H * H);
}

double max_conductance(const Scene& scene, std::size_t tool) {
  double h = 0;
  for (const Interface& interface : scene.interfaces)
    if (interface.tool == static_cast<Index>(tool)) h = std::max(h, contact::highest(interface.law));
  return h;
}

}  // namespace

double active_time(const Scene& scene, std::size_t tool) {
  double time = 0;
  for (const Stage& stage : scene.stages)
    for (const StageTool& placed : stage.tools)
      if (placed.tool == static_cast<Index>(tool)) time += stage.duration;
  return time;
}

Conductivities conductivities(const Scene& scene, double length) {
  thermal::Material material = *scene.glass.thermal;
  const double hot = scene.glass.initial_temperature, alone = material.conductivity(hot);
  if (!thermal::is_rosseland(material)) material.radiation = ContainerGlass{}.radiation;
  material.radiation->thin_wall = true;
  return {alone, thermal::conductivity(material, hot, thermal::thin_wall_factor(*material.radiation, length)),
          thermal::conductivity(material, hot, 1)};
}

double heat_gain(const Scene& scene, const HalfSpaces& more, const HalfSpaces& less) {
  const double hot = scene.glass.initial_temperature;
  double most = 0;
  for (std::size_t i = 0; i < scene.tools.size(); ++i) {
    const Tool& tool = scene.tools[i];
    const double h = max_conductance(scene, i), time = active_time(scene, i), cold = tool.initial_temperature;
    if (!tool.thermal || h == 0 || time == 0) continue;
    const double warming = 1 / effusivity(*tool.thermal, cold, tool.thermal->conductivity(cold));
    const auto heat = [&](const HalfSpaces& pair) {
      return exchanged(
          h, 1 / effusivity(*scene.glass.thermal, hot, pair.conductivity) + (pair.isothermal ? 0 : warming), time);
    };
    most = std::max(most, heat(more) / heat(less) - 1);
  }
  return most;
}

}  // namespace parison::forming
