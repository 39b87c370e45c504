#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <optional>

#include "core/case/table.hpp"
#include "forming/flow/viscosity/viscosity_table.hpp"

namespace parison::flow {

/// The law of Vogel (1921), Fulcher (1925) and Tammann (1926): log10 eta = A + B/(T - T0) with eta in Pa.s, at most 12.
struct Viscosity {
  double A = 0;
  double B = 0, T0 = 0;                      ///< K
  std::optional<double> constant;            ///< Pa.s, at every temperature, instead of the law
  std::optional<ViscosityTable> table = {};  ///< measured points instead of the law

  /// eta, Pa.s, at a temperature in K.
  double operator()(double temperature) const;
  /// eta, Pa.s, that the flow takes: at most the shear modulus of glass, 30 GPa, times a second. Stiffer glass is
  /// elastic while a stage lasts; as a fluid it would bear stresses that no strain of glass makes.
  double in_flow(double temperature) const;
  /// Whether glass of a temperature is softer in the flow than by its law.
  bool is_softened(double temperature) const;
  /// ln eta, eta in Pa.s, of glass in equilibrium at a temperature in K: without that limit.
  double equilibrium_logarithm(double temperature) const;
  /// Whether glass of a temperature should be stiffer than this law lets it be.
  bool is_capped(double temperature) const;
  /// d eta / dT, Pa.s/K.
  double derivative(double temperature) const;
  /// d ln eta / dT, 1/K.
  double log_derivative(double temperature) const;
  /// ln eta, eta in Pa.s, and its derivative, 1/K, at many temperatures.
  Eigen::ArrayXd logarithm(const Eigen::ArrayXd& temperature) const;
  Eigen::ArrayXd log_derivative(const Eigen::ArrayXd& temperature) const;
  /// ln eta, eta in Pa.s, that the flow takes, at many temperatures.
  Eigen::ArrayXd logarithm_in_flow(const Eigen::ArrayXd& temperature) const;
};

/// Shear thinning by Carreau (1972): the viscosity is multiplied by (1 + (lambda rate)^2)^((n-1)/2), where rate is the
/// shear rate sqrt(2 D:D), 1/s.
struct Carreau {
  double time;      ///< lambda, s
  double exponent;  ///< n

  /// The factor at a square of the shear rate, 1/s2.
  double operator()(double squared_rate) const;
  /// Derivative of the factor's natural logarithm with respect to that square, s2.
  double log_derivative(double squared_rate) const;
};

/// Flow properties of the glass.
struct Material {
  double density;  ///< kg/m3
  Viscosity viscosity;
  std::optional<Carreau> shear_thinning;
  double surface_tension = 0;         ///< N/m
  core::Table relative_density = {};  ///< density over `density`, by temperature, K; empty: the same at all
};

/// Tangential behaviour of the glass on a tool while it is pressed against it.
struct Friction {
  enum class Law { slip, stick, navier, grip } law = Law::stick;  ///< grip: sticks in tension too
  double coefficient = 0;                                         ///< Navier beta, Pa.s/m
  std::optional<double> coulomb;                                  ///< cap of the shear stress, times contact pressure
  /// ln beta over the temperature of the glass at the contact, K, instead of one beta.
  std::optional<core::Table> by_temperature = {};

  /// beta, Pa.s/m, at a temperature in K.
  double coefficient_at(double temperature) const;
};

}  // namespace parison::flow
