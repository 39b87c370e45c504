#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "core/table.hpp"

namespace parison::thermal {

/// Internal radiation as Rosseland conduction: k_r = 16/3 n^2 sigma T^3 / kappa, T in K.
struct Radiation {
  double refractive_index;
  double absorption;        ///< kappa_R, 1/m
  bool thin_wall = true;    ///< multiply k_r by 1/(1 + 4/(3 kappa w)), w the local wall thickness
};

/// Thermal properties of a body; tables over temperature in K.
struct Material {
  double density;               ///< kg/m3
  core::Table heat_capacity;    ///< J/kg/K
  core::Table conductivity;     ///< W/m/K, without internal radiation
  std::optional<Radiation> radiation;
};

/// What a piece of surface exchanges with its surroundings, positive out of the body:
/// q = h (T - air) + emissivity sigma (T^4 - ambient^4).
struct SurfaceExchange {
  double h = 0;                    ///< W/m2/K
  double air_temperature = 300;    ///< K
  double emissivity = 0;
  double ambient_temperature = 300;  ///< K
};

}  // namespace parison::thermal
