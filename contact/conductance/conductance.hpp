#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "core/math/dual.hpp"
#include "core/math/numbers.hpp"

namespace parison::contact {

/// 1/(1 + exp(-z)), with the bits of Eigen's logistic function of an array, whose exponential is not the standard
/// library's.
inline double logistic(double z) {
  const Eigen::Array2d packet = Eigen::Array2d::Constant(z).logistic();
  return packet[0];
}
template <typename Value, typename Derivative>
core::Dual<Value, Derivative> logistic(const core::Dual<Value, Derivative>& z) {
  const Value result = logistic(z.value);
  return {result, result * (1 - result) * z.derivative};
}

/// A conductance law gives h, W/m2/K, from the contact pressure, Pa, and the viscosity of the glass surface, Pa.s. The
/// call operators are templates on the number: double, an Eigen array, or core::Dual of either for derivatives.

/// The same h for every pressure and viscosity.
struct ConstantConductance {
  double h;  ///< W/m2/K

  template <typename Number>
  Number operator()(const Number& pressure, const Number&) const {
    return core::constant_like(pressure, h);
  }
};

/// h = h0 + (h1 - h0) x/(1 + x), x = (p/p_ref)^a (eta_ref/eta)^b (assumed, inside the published band). `Constant` is
/// core::Dual for derivatives with respect to the constants.
template <typename Constant>
struct PressureViscosityLaw {
  Constant h0 = 500, h1 = 20000;  ///< W/m2/K
  Constant p_ref = 0.2e6;         ///< Pa
  Constant eta_ref = 1e3;         ///< Pa.s
  Constant a = 1, b = 0.25;

  /// The part of ln x that depends on the pressure: a ln(p/p_ref) + b ln eta_ref.
  template <typename Number>
  Number pressure_part(const Number& pressure) const {
    using std::log;
    constexpr double log_zero = -600;  // x = 1e-261 gives h0 exactly, and no subnormal numbers, which are slow
    const Number relative = pressure / p_ref;
    const double power = core::value_of(a);
    if (core::value_of(relative) > 0) return b * log(eta_ref) + a * log(relative);
    return b * log(eta_ref) + core::constant_like(relative, power == 0 ? 0 : power > 0 ? log_zero : -log_zero);
  }

  /// h from that part and the natural logarithm of the viscosity.
  template <typename Number>
  Number from_logarithms(const Number& pressure_part, const Number& log_viscosity) const {
    const Number log_x = pressure_part - b * log_viscosity;
    return h0 + (h1 - h0) * logistic(log_x);
  }

  template <typename Number>
  Number operator()(const Number& pressure, const Number& viscosity) const {
    using std::log;
    return from_logarithms(pressure_part(pressure), Number(log(viscosity)));
  }
};
using PressureViscosityConductance = PressureViscosityLaw<double>;

/// Bilinear interpolation in ln p and ln eta, constant beyond the first and last entries.
struct TableConductance {
  std::vector<double> pressure, viscosity;  ///< Pa, Pa.s; strictly increasing
  std::vector<double> h;                    ///< W/m2/K, h[i * viscosity.size() + j]

  template <typename Number>
  Number operator()(const Number& pressure_at, const Number& viscosity_at) const;
  /// Whether one of them lies beyond the ends of the table.
  bool clamps(double pressure_at, double viscosity_at) const;
};

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
  constexpr double atmosphere = 101325, gas_constant = 287.053;
  const Number logarithm = log(temperature);
  const double constant = 1.458e-6 / atmosphere * std::sqrt(M_PI * gas_constant / 2);
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
    constexpr double gamma = core::heat_ratio_of_air, prandtl = 0.70;
    return 2 * ((2 - accommodation) / accommodation * 2 * gamma / (gamma + 1) / prandtl) * air_free_path(temperature);
  }

  /// W/m2/K at an opening, m, between faces of these temperatures, K.
  template <typename Number>
  Number at_opening(double opening, const Number& glass, const Number& tool) const {
    const Number mean = 0.5 * (glass + tool);
    const Number radiation =
        exchange_emissivity * core::stefan_boltzmann * ((glass * glass + tool * tool) * (glass + tool));
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

using ConductanceLaw =
    std::variant<ConstantConductance, PressureViscosityConductance, TableConductance, GapConductance>;

/// h and its derivative.
struct ConductanceValue {
  double h;              ///< W/m2/K
  double dh_deta;        ///< W/m2/K/(Pa.s)
  bool clamped = false;  ///< the pressure or the viscosity lies beyond the ends of a table
};
/// Pressures below zero count as zero; the viscosity is positive. Of a gap the value of a contact as old as it gets.
ConductanceValue conductance(const ConductanceLaw& law, double pressure, double viscosity);

/// The largest value that a law can give, W/m2/K.
double highest(const ConductanceLaw& law);

namespace detail {
/// A value on a logarithmic axis lies between the entries `low` and `high`, at `weight` from the first to the second.
template <typename Number>
struct AxisPosition {
  std::size_t low, high;
  Number weight;
};

template <typename Number>
AxisPosition<Number> locate(const std::vector<double>& axis, const Number& x) {
  using std::log;
  const double value = core::value_of(x);
  if (axis.size() == 1 || value < axis.front()) return {0, 0, core::constant_like(x, 0)};
  const std::size_t last = axis.size() - 1;
  if (value > axis.back()) return {last, last, core::constant_like(x, 0)};
  const std::size_t high = std::upper_bound(axis.begin() + 1, axis.end() - 1, value) - axis.begin();
  return {high - 1, high, log(x / axis[high - 1]) / std::log(axis[high] / axis[high - 1])};
}
}  // namespace detail

template <typename Number>
Number TableConductance::operator()(const Number& pressure_at, const Number& viscosity_at) const {
  const auto p = detail::locate(pressure, pressure_at), eta = detail::locate(viscosity, viscosity_at);
  const auto along_viscosity = [&](std::size_t i) -> Number {
    const double low = h[i * viscosity.size() + eta.low], high = h[i * viscosity.size() + eta.high];
    return low + (high - low) * eta.weight;
  };
  const Number low = along_viscosity(p.low), high = along_viscosity(p.high);
  return low + p.weight * (high - low);
}

}  // namespace parison::contact
