// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/radiation/fresnel.hpp"

#include <algorithm>
#include <cmath>

#include "core/mesh/element.hpp"

namespace parison::thermal {

double critical_cosine(double n) {
  return std::sqrt(std::max(0.0, 1 - 1 / (n * n)));
}

double fresnel_reflectivity(double n, double mu) {
  const double square = 1 - n * n * (1 - mu * mu);  // of the cosine outside, by Snell's law
  if (square <= 0) return 1;
  const double outside = std::sqrt(square);
  const double across = (n * mu - outside) / (n * mu + outside), along = (mu - n * outside) / (mu + n * outside);
  return 0.5 * (across * across + along * along);
}

ReflectivityMoments reflectivity_moments(double n, double from, double to) {
  // All is reflected below the critical cosine; above it the reflectivity falls like a root, which mu = start +
  // (to - start) s^2 makes smooth.
  const double total = std::clamp(critical_cosine(n), from, to), rest = to - total;
  ReflectivityMoments sum{(total * total - from * from) / 2, (total * total * total - from * from * from) / 3};
  constexpr int panels = 32;
  for (int panel = 0; panel < panels; ++panel)
    for (const auto& at : core::edge_rule(5)) {
      const double s = (panel + at.s) / panels, mu = total + rest * s * s;
      const double part = fresnel_reflectivity(n, mu) * 2 * rest * s * at.weight / panels;
      sum.first += part * mu;
      sum.second += part * mu * mu;
    }
  return sum;
}

double surface_emissivity(double n) {
  return n * n * (1 - 2 * reflectivity_moments(n).first);
}

}  // namespace parison::thermal
