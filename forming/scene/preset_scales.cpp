// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/preset_scales.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "forming/scene/describe/dimensionless_numbers.hpp"

namespace parison::forming {

double preset_length_scale(const Scene& scene) {
  constexpr double largest = 200e-6;  // m3, of the bodies for which the presets are made: some 480 g of glass
  if (!scene.has_flow() || scene.geometry != core::Geometry::axisymmetric) return 1;
  return std::max(1.0, std::cbrt(outline_volume(scene.glass.profile, scene.geometry) / largest));
}

void fit_preset_lengths(Scene& scene) {
  const double scale = preset_length_scale(scene);
  if (scale == 1) return;
  for (const Setting& setting : settings())
    if (is_length(setting))
      scene.accuracy.*setting.value = std::min(scale * scene.accuracy.*setting.value, setting.max);
}

bool is_length(const Setting& setting) {
  return std::strcmp(setting.unit, "mm") == 0;
}

double longest_step(const Scene& scene, const Stage& stage) {
  if (stage.cools) return stage.duration;
  constexpr double usual = 20;  // s
  const double step = scene.accuracy.max_step;
  return scene.accuracy_origin.count("max_step") ? step : step * std::max(1.0, stage.duration / usual);
}

double usual_output_interval(const Scene& scene) {
  constexpr double usual = 0.1, outputs = 600;  // s
  double duration = 0;
  for (const Stage& stage : scene.stages)
    if (!stage.cools) duration += stage.duration;
  return std::max(usual, duration / outputs);
}

}  // namespace parison::forming
