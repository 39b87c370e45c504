#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "thermal/material.hpp"
#include "thermal/shapes.hpp"

namespace parison::thermal {

inline constexpr double stefan_boltzmann = 5.670374419e-8;  ///< W/m2/K4
inline constexpr double content_reference = 273.15;         ///< K, where enthalpy and heat content are zero

/// What diffusion through a wall of thickness w keeps of the Rosseland conductivity: 1/(1 + 4/(3 kappa w)).
double thin_wall_factor(const Radiation& radiation, double wall_thickness);

/// Conductivity with internal radiation, W/m/K; `thin_wall` multiplies the radiative part (physics.md, section 3).
double conductivity(const Material& material, double temperature, double thin_wall = 1);

/// The same, prepared for many evaluations.
class Conductivity {
 public:
  explicit Conductivity(const Material& material);
  PointArray operator()(const PointArray& temperature, const PointArray& thin_wall) const;
  /// Derivative with respect to temperature, W/m/K2.
  PointArray slope(const PointArray& temperature, const PointArray& thin_wall) const;

 private:
  core::Table phonon_;
  double radiant_ = 0;  ///< W/m/K4
};

/// Specific enthalpy and its slope, the heat capacity.
struct EnthalpyValue {
  double h;  ///< J/kg
  double c;  ///< J/kg/K
};

/// The integral of a heat capacity table, prepared for many evaluations.
class Enthalpy {
 public:
  explicit Enthalpy(const core::Table& heat_capacity);
  EnthalpyValue operator()(double temperature) const;
  PointArray enthalpy(const PointArray& temperature) const;  ///< J/kg
  PointArray capacity(const PointArray& temperature) const;  ///< J/kg/K

 private:
  core::Table capacity_;
  std::vector<double> at_knot_;  ///< J/kg
};

/// Heat flux out of a surface and its slope.
struct SurfaceFlux {
  double q;      ///< W/m2
  double dq_dT;  ///< W/m2/K
};
SurfaceFlux surface_flux(const SurfaceExchange& exchange, double temperature);

}  // namespace parison::thermal
