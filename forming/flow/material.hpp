#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <optional>

namespace parison::flow {

/// Vogel-Fulcher-Tammann: log10 eta = A + B/(T - T0); T and T0 in K, B in K, eta in Pa.s. `constant` replaces it when
/// set.
struct Viscosity {
  double A = 0, B = 0, T0 = 0;
  std::optional<double> constant;

  double operator()(double temperature) const;
  /// d eta / dT, Pa.s/K.
  double derivative(double temperature) const;
  /// d ln eta / dT, 1/K.
  double log_derivative(double temperature) const;
  /// ln eta, eta in Pa.s, and its derivative, 1/K, at many temperatures.
  Eigen::ArrayXd logarithm(const Eigen::ArrayXd& temperature) const;
  Eigen::ArrayXd log_derivative(const Eigen::ArrayXd& temperature) const;
};

/// Carreau factor on the viscosity: (1 + (lambda rate)^2)^((n-1)/2).
struct Carreau {
  double time;      ///< lambda, s
  double exponent;  ///< n
};

/// Flow properties of the glass.
struct Material {
  double density;  ///< kg/m3
  Viscosity viscosity;
  std::optional<Carreau> shear_thinning;
  double surface_tension = 0;  ///< N/m
};

/// Tangential behaviour of the glass on a tool while it is pressed against it.
struct Friction {
  enum class Law { slip, stick, navier, grip } law = Law::stick;  ///< grip: stick that also holds in tension
  double coefficient = 0;                                         ///< Navier beta, Pa.s/m
  std::optional<double> coulomb;                                  ///< cap of the shear stress, times contact pressure
};

}  // namespace parison::flow
