// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/preset_lengths.hpp"

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

}  // namespace parison::forming
