// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/light_laws.hpp"

#include <cmath>
#include <limits>

namespace parison::thermal {

namespace {

/// Within a cone the intensity is a + b mu. What comes back from the surface has the flux of what is reflected and of
/// what enters, int mu (a - b mu) = int R mu (a + b mu) + entering, which gives c.
LightGroup p1_group(const Cone& cone, double index, int band, double absorption) {
  const ReflectivityMoments r = reflectivity_moments(index, cone.from, cone.to);
  const double first = cone.first(), second = cone.second(), share = cone.share();
  const double leaving = std::max(0.0, first - r.first);  // zero to round-off where all is reflected
  return {band,
          absorption,
          share,
          second / share / absorption,
          leaving < 1e-14 ? 0 : second * leaving / ((second + r.second) * share),
          first / share};
}

/// Rays carry the light themselves: what leaves a surface is (G - G_eq)/(4 n^2), G/(4 n^2) being the flux outside of
/// it.
LightGroup ray_group(double index, int band, double absorption) {
  const double open = 1 / (4 * index * index);
  return {band, absorption, 1, 0, open, open};
}

std::vector<Cone> cones_of(const Radiation& radiation) {
  const double critical = critical_cosine(radiation.refractive_index);
  if (radiation.model == Radiation::Model::p1_cones && critical > 0) return {{0, critical}, {critical, 1}};
  return {{0, 1}};
}

}  // namespace

LightLaws::LightLaws(const Radiation& radiation)
    : square_(radiation.refractive_index * radiation.refractive_index),
      rays_(radiation.model == Radiation::Model::transfer) {
  double from = 0;
  for (const Band& band : radiation.bands) {
    const auto at = static_cast<int>(emission_.size());
    if (rays_)
      groups_.push_back(ray_group(radiation.refractive_index, at, band.absorption));
    else
      for (const Cone& cone : cones_of(radiation))
        groups_.push_back(p1_group(cone, radiation.refractive_index, at, band.absorption));
    emission_.emplace_back(from, band.up_to);
    from = band.up_to;
  }
  if (std::isfinite(from)) opaque_.emplace(from, std::numeric_limits<double>::infinity());
}

double LightLaws::to_tool(int g, double emissivity) const {
  // The tool's radiosity J = E + q (1 - e)/e is what the glass sees: q = c (G - share 4 n^2 J). Of two cones the light
  // leaves through one.
  const LightGroup& group = groups_[g];
  if (rays_) return emissivity * group.open;
  if (group.open == 0 || emissivity == 0) return 0;
  return 1 / (1 / group.open + 4 * square_ * group.share * (1 / emissivity - 1));
}

double grey_exchange(double a, double b) {
  return a > 0 && b > 0 ? 1 / (1 / a + 1 / b - 1) : 0;
}

}  // namespace parison::thermal
