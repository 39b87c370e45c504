// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/light_laws.hpp"

#include <cmath>
#include <limits>

namespace parison::thermal {

LightLaws::LightLaws(const Radiation& radiation)
    : bands_(radiation.bands), square_(radiation.refractive_index * radiation.refractive_index) {
  double from = 0;
  for (const Band& band : bands_) {
    emission_.emplace_back(from, band.up_to);
    from = band.up_to;
  }
  if (std::isfinite(from)) opaque_.emplace(from, std::numeric_limits<double>::infinity());
  const ReflectivityMoments r = reflectivity_moments(radiation.refractive_index);
  open_ = (1 - 2 * r.first) / (2 * (1 + 3 * r.second));
}

double LightLaws::to_tool(double emissivity) const {
  // The tool's radiosity J = E + q (1 - e)/e is what the glass sees: q = c (G - 4 n^2 J).
  return emissivity > 0 ? 1 / (1 / open_ + 4 * square_ * (1 / emissivity - 1)) : 0;
}

double grey_exchange(double a, double b) {
  return a > 0 && b > 0 ? 1 / (1 / a + 1 / b - 1) : 0;
}

}  // namespace parison::thermal
