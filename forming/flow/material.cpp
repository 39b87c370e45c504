// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/material.hpp"

#include <cmath>

#include "core/math/dual.hpp"

namespace parison::flow {

namespace {

/// Glass with a viscosity of 1e12 Pa.s does not deform within the time of a run. The law stays there at lower
/// temperatures, also near and below T0 where it has no value.
constexpr double max_log10 = 12;

/// ln eta at one or more temperatures, which are numbers, arrays or core::Dual.
template <typename Number>
Number log_viscosity(const Viscosity& law, const Number& temperature) {
  if (law.constant) return core::constant_like(temperature, std::log(*law.constant));
  const auto above = temperature - law.T0;
  return std::log(10) * core::choose(core::value_of(above) > 0, core::min(law.A + law.B / above, max_log10), max_log10);
}

/// ln of the Carreau factor at a square of the shear rate.
template <typename Number>
Number log_factor(const Carreau& law, const Number& squared_rate) {
  using std::log;
  return 0.5 * (law.exponent - 1) * log(1 + law.time * law.time * squared_rate);
}

}  // namespace

bool Viscosity::is_capped(double temperature) const {
  return !constant && !(temperature > T0 && A + B / (temperature - T0) < max_log10);
}

double Viscosity::operator()(double temperature) const {
  return constant ? *constant : std::exp(log_viscosity(*this, temperature));
}

Eigen::ArrayXd Viscosity::logarithm(const Eigen::ArrayXd& temperature) const {
  return log_viscosity(*this, temperature);
}

Eigen::ArrayXd Viscosity::log_derivative(const Eigen::ArrayXd& temperature) const {
  return temperature.unaryExpr([&](double T) { return log_derivative(T); });
}

double Viscosity::derivative(double temperature) const {
  return (*this)(temperature)*log_derivative(temperature);
}

double Viscosity::log_derivative(double temperature) const {
  return log_viscosity(*this, core::Dual<double>{temperature, 1}).derivative;
}

double Carreau::operator()(double squared_rate) const {
  return std::exp(log_factor(*this, squared_rate));
}

double Carreau::log_derivative(double squared_rate) const {
  return log_factor(*this, core::Dual<double>{squared_rate, 1}).derivative;
}

}  // namespace parison::flow
