#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/case/table.hpp"
#include "forming/cooling/glass_law.hpp"

namespace parison::cooling {

inline constexpr double thickness = 6e-3, kelvin = 273.15;

/// Temperatures of a plate: a mean and what its middle has above its surface, straight between times.
struct History {
  core::Table mean, apart;  // K over s

  /// At a height over half the thickness.
  double at(double time, double height) const { return mean(time) + apart(time) * (1.0 / 3 - height * height); }
  double end() const { return mean.x.back(); }
};

/// Stress of the middle and of the surface and the largest without sign, MPa, by points through half the thickness,
/// with small steps of backward Euler for branches and structure, extrapolated from two step lengths.
inline std::array<double, 3> by_points(const GlassLaw& law, const History& history, int steps) {
  constexpr int points = 21;
  struct At {
    Branches stress = Branches::Zero(), fictive;
    double thermal = 0;
  };
  std::vector<At> at(points);
  for (int i = 0; i < points; ++i) at[i].fictive = Branches::Constant(history.at(0, double(i) / (points - 1)));
  const double G = law.shear_modulus(), K = law.bulk_modulus(), dt = history.end() / steps;
  double in_plane = 0, before = 0;
  std::vector<double> mean(points, 0), thickening(points, 0), sigma(points, 0);
  for (int step = 1; step <= steps; ++step) {
    std::vector<double> constant(points), slope(points);
    std::vector<Branches> factor(points), left(points);
    for (int i = 0; i < points; ++i) {
      const double height = double(i) / (points - 1), T = history.at(step * dt, height),
                   T_before = history.at((step - 1) * dt, height);
      const double Tf = (law.structure.weight * at[i].fictive).sum();
      const double pace = dt * G / std::exp(law.log_viscosity(T, Tf));
      const Branches q = pace / law.structure.time;
      at[i].fictive = (at[i].fictive + q * T) / (1 + q);
      const double change = (law.structure.weight * at[i].fictive).sum() - Tf;
      at[i].thermal += law.solid_expansion * (T - T_before) + (law.liquid_expansion - law.solid_expansion) * change;
      // s' = (s + 2 G w de)/(1 + q), de_x = (ex - ez)/3 of the increments; sigma_z = 0.
      const Branches relaxing = 1 / (1 + pace / law.shear.time);
      left[i] = at[i].stress * relaxing;
      factor[i] = 2 * G * law.shear.weight * relaxing;
      // With s_z = -2 s_x: p' = K (2 ex + ez - 3 eth) (tension), s_z + p' = 0.
      const double S = left[i].sum(), F = factor[i].sum() / 3;
      // S + F (dex - dez) = s_x; -2 s_x + K (2 ex + ez - 3 eth) = 0 with ez = thickening + dez.
      const double whole = K + 2 * F;
      constant[i] = (2 * S - K * (2 * before + thickening[i] - 3 * at[i].thermal)) / whole;  // dez at dex = 0
      slope[i] = (2 * F - 2 * K) / whole;
    }
    // sigma_x = s_x + p' = 3 s_x; mean over the thickness is zero.
    double sum = 0, by = 0;
    for (int i = 0; i < points; ++i) {
      const double weight = i == 0 || i == points - 1 ? 1 : i % 2 ? 4 : 2;
      const double F = factor[i].sum() / 3;
      sum += weight * (left[i].sum() - F * constant[i]);
      by += weight * F * (1 - slope[i]);
    }
    const double dex = -sum / by;
    in_plane = before + dex;
    for (int i = 0; i < points; ++i) {
      const double dez = constant[i] + slope[i] * dex;
      at[i].stress = left[i] + factor[i] * (dex - dez) / 3;
      thickening[i] += dez;
      sigma[i] = 3 * at[i].stress.sum();
    }
    before = in_plane;
  }
  double largest = 0;
  for (const double here : sigma) largest = std::max(largest, std::abs(here));
  return {1e-6 * sigma.front(), 1e-6 * sigma.back(), 1e-6 * largest};
}

}  // namespace parison::cooling
