// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/material.hpp"

#include <algorithm>
#include <cmath>

namespace parison::flow {

namespace {

/// Beyond this the glass does not move in the time of a run; the exponent is held there, and near and below T0.
constexpr double max_exponent = 12;

}  // namespace

double Viscosity::operator()(double temperature) const {
  if (constant) return *constant;
  const double above = temperature - T0;
  const double exponent = above > 0 ? A + B / above : max_exponent;
  return std::exp(std::log(10) * std::min(exponent, max_exponent));
}

Eigen::ArrayXd Viscosity::logarithm(const Eigen::ArrayXd& temperature) const {
  if (constant) return Eigen::ArrayXd::Constant(temperature.size(), std::log(*constant));
  const Eigen::ArrayXd above = temperature - T0;
  return std::log(10) * (above > 0).select((A + B / above).min(max_exponent), max_exponent);
}

Eigen::ArrayXd Viscosity::log_derivative(const Eigen::ArrayXd& temperature) const {
  return temperature.unaryExpr([&](double T) { return log_derivative(T); });
}

double Viscosity::derivative(double temperature) const {
  return (*this)(temperature)*log_derivative(temperature);
}

double Viscosity::log_derivative(double temperature) const {
  if (constant) return 0;
  const double above = temperature - T0;
  if (above <= 0 || A + B / above >= max_exponent) return 0;
  return -std::log(10) * B / (above * above);
}

}  // namespace parison::flow
