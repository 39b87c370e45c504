#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "core/math/dual.hpp"

namespace parison::contact {

/// Thermal conductivity of air, W/m/K, at a temperature, K (U.S. Standard Atmosphere, 1976, NOAA-S/T 76-1562, eq. 53).
template <typename Number>
Number air_conductivity(const Number& temperature) {
  using std::exp;
  using std::log;
  const Number logarithm = log(temperature);
  const Number spread = 245.4 * exp(-12 * std::log(10.0) / temperature);
  return 2.64638e-3 * exp(1.5 * logarithm) / (temperature + spread);
}

/// Mean free path in air at one atmosphere, m: (viscosity/pressure) sqrt(pi R T/(2 M)), with the viscosity by
/// Sutherland's formula (the same, eq. 51).
template <typename Number>
Number air_free_path(const Number& temperature) {
  using std::exp;
  using std::log;
  constexpr double atmosphere = 101325, gas_constant = 287.053, pi = 3.14159265358979323846;
  const Number logarithm = log(temperature);
  const double constant = 1.458e-6 / atmosphere * std::sqrt(pi * gas_constant / 2);
  return constant * exp(2 * logarithm) / (110.4 + temperature);
}

/// The gap between glass and tool as an evolving quantity:
///     d(gap)/dt = (open_gap - gap)/opening_time - closing (pressure/viscosity) (gap - touch_gap),
/// from touch_gap at first touch. The state is the opening, gap - touch_gap: zero where nothing has touched yet.
/// The conductance is k_air/(gap + jump distance) with the jump distance of both faces, and radiation between them.
struct GapConductance {
  double touch_gap = 0;      ///< at first touch, m
  double open_gap = 0;       ///< that of an old contact without pressure, m; not below touch_gap
  double opening_time = 0;   ///< s
  double closing = 0;        ///< times pressure over viscosity: the rate at which the gap closes
  double accommodation = 1;  ///< thermal accommodation coefficient of both faces, above 0 to 1
  /// 1/(1/emissivity of the glass + 1/emissivity of the tool - 1); 0 where the radiation is counted elsewhere.
  double exchange_emissivity = 0;

  /// Rate at which pressure, Pa, and viscosity, Pa.s, close the opening, 1/s.
  double closing_rate(double pressure, double viscosity) const { return closing * pressure / viscosity; }

  /// Opening, m, a time, s, after it was `opening`, with a constant closing rate, 1/s: the equation's solution.
  double opening_after(double opening, double closing_rate, double time) const;

  /// Temperature jumps of both faces as a length, m (E. H. Kennard, Kinetic Theory of Gases, 1938, eq. 191a): each is
  /// (2 - a)/a 2 gamma/(gamma + 1)/Pr free paths.
  template <typename Number>
  Number jump_distance(const Number& temperature) const {
    constexpr double gamma = 1.4, prandtl = 0.70;
    return 2 * ((2 - accommodation) / accommodation * 2 * gamma / (gamma + 1) / prandtl) * air_free_path(temperature);
  }

  /// W/m2/K at an opening, m, between faces of these temperatures, K.
  template <typename Number>
  Number at_opening(double opening, const Number& glass, const Number& tool) const {
    constexpr double stefan_boltzmann = 5.670374419e-8;
    const Number mean = 0.5 * (glass + tool);
    const Number radiation = exchange_emissivity * stefan_boltzmann * ((glass * glass + tool * tool) * (glass + tool));
    return air_conductivity(mean) / (jump_distance(mean) + core::constant_like(mean, touch_gap + opening)) + radiation;
  }

  /// Of a contact as old as it gets under a pressure, Pa, and viscosity, Pa.s, by conduction at a temperature, K, usual
  /// for the gas between glass and mould.
  template <typename Number>
  Number operator()(const Number& pressure, const Number& viscosity) const {
    constexpr double usual = 800;
    const Number closed = opening_time * closing * (pressure / viscosity);
    const double narrowest = touch_gap + jump_distance(usual);
    return air_conductivity(usual) / (narrowest + (open_gap - touch_gap) / (1 + closed));
  }
};

}  // namespace parison::contact
