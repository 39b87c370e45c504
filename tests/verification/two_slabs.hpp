#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <complex>

namespace parison::tests {

/// Insulated slab that exchanges heat at one face: W/m/K, kg/m3, J/kg/K, m, degC.
struct Slab {
  double conductivity, density, heat_capacity, height, temperature;
};

/// Two slabs brought together with the conductance h, W/m2/K.
struct TwoSlabs {
  Slab hot, cold;
  double h;

  using Complex = std::complex<double>;
  /// Transform of a slab's surface temperature per transform of the flux into it, K m2/W.
  static Complex rise(const Slab& slab, Complex s) {
    const double capacity = slab.density * slab.heat_capacity;
    return 1.0 / (std::sqrt(slab.conductivity * capacity * s) *
                  std::tanh(slab.height * std::sqrt(capacity / slab.conductivity * s)));
  }
  Complex flux(Complex s) const {
    return h * (hot.temperature - cold.temperature) / s / (1.0 + h * (rise(hot, s) + rise(cold, s)));
  }

  double hot_side(double time) const {
    return hot.temperature - invert([this](Complex s) { return rise(hot, s) * flux(s); }, time);
  }
  double cold_side(double time) const {
    return cold.temperature + invert([this](Complex s) { return rise(cold, s) * flux(s); }, time);
  }
  /// Heat exchanged since the start, J/m2.
  double heat(double time) const {
    return invert([this](Complex s) { return flux(s) / s; }, time);
  }

  /// Inverse Laplace transform by the fixed Talbot rule (Abate and Valko 2004).
  template <typename Transform>
  static double invert(const Transform& transform, double time) {
    constexpr int points = 32;
    const double r = 2 * points / (5 * time);
    double sum = 0.5 * std::exp(r * time) * transform(Complex(r)).real();
    for (int k = 1; k < points; ++k) {
      const double theta = k * M_PI / points, cot = 1 / std::tan(theta);
      const Complex s = r * theta * Complex(cot, 1), slope(1, theta + (theta * cot - 1) * cot);
      sum += (std::exp(time * s) * transform(s) * slope).real();
    }
    return r / points * sum;
  }
};

}  // namespace parison::tests
