// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/material.hpp"

#include <algorithm>
#include <cmath>

#include "core/math/dual.hpp"

namespace parison::flow {

namespace {

/// Glass with a viscosity of 1e12 Pa.s does not deform within the time of a run. The law stays there at lower
/// temperatures, also near and below T0 where it has no value.
constexpr double max_log10 = 12;
/// Shear modulus of glass (N. P. Bansal, R. H. Doremus, Handbook of Glass Properties, 1986: 29 to 30 GPa for soda-lime
/// glass) times a second, of the order of a stage.
constexpr double stiffest_in_flow = 30e9 * 1;  // Pa.s

/// A viscosity by measured points: ln eta, at most that of frozen glass, and its derivative.
ViscosityTable::Value capped(const ViscosityTable& table, double temperature) {
  const ViscosityTable::Value value = table(temperature);
  const double highest = std::log(10) * max_log10;
  return value.logarithm < highest ? value : ViscosityTable::Value{highest, 0};
}

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

double Viscosity::equilibrium_logarithm(double temperature) const {
  if (table) return (*table)(temperature).logarithm;
  constexpr double nearest = 1;  // K, to T0: such glass does not flow
  return constant ? std::log(*constant) : std::log(10) * (A + B / std::max(temperature - T0, nearest));
}

bool Viscosity::is_capped(double temperature) const {
  if (table) return (*table)(temperature).logarithm >= std::log(10) * max_log10;
  return !constant && !(temperature > T0 && A + B / (temperature - T0) < max_log10);
}

double Viscosity::operator()(double temperature) const {
  if (table) return std::exp(capped(*table, temperature).logarithm);
  return constant ? *constant : std::exp(log_viscosity(*this, temperature));
}

double Viscosity::in_flow(double temperature) const {
  const double viscosity = (*this)(temperature);
  return constant ? viscosity : std::min(viscosity, stiffest_in_flow);
}

bool Viscosity::is_softened(double temperature) const {
  return !constant && (*this)(temperature) > stiffest_in_flow;
}

Eigen::ArrayXd Viscosity::logarithm(const Eigen::ArrayXd& temperature) const {
  if (table) return temperature.unaryExpr([&](double T) { return capped(*table, T).logarithm; });
  return log_viscosity(*this, temperature);
}

Eigen::ArrayXd Viscosity::logarithm_in_flow(const Eigen::ArrayXd& temperature) const {
  const Eigen::ArrayXd value = logarithm(temperature);
  return constant ? value : value.min(std::log(stiffest_in_flow));
}

Eigen::ArrayXd Viscosity::log_derivative(const Eigen::ArrayXd& temperature) const {
  return temperature.unaryExpr([&](double T) { return log_derivative(T); });
}

double Viscosity::derivative(double temperature) const {
  return (*this)(temperature)*log_derivative(temperature);
}

double Viscosity::log_derivative(double temperature) const {
  if (table) return capped(*table, temperature).derivative;
  return log_viscosity(*this, core::Dual<double>{temperature, 1}).derivative;
}

double Carreau::operator()(double squared_rate) const {
  return std::exp(log_factor(*this, squared_rate));
}

double Carreau::log_derivative(double squared_rate) const {
  return log_factor(*this, core::Dual<double>{squared_rate, 1}).derivative;
}

double Friction::coefficient_at(double temperature) const {
  return by_temperature ? std::exp((*by_temperature)(temperature)) : coefficient;
}

}  // namespace parison::flow
