#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::flow {

using core::Index;

/// Air that glass and tools enclose, at the start of a step.
struct AirPocket {
  double volume;                  ///< m3
  double energy;                  ///< pressure times volume, J
  double exponent;                ///< n of p V^n = constant: 1 isothermal, 1.4 adiabatic
  double vent = 0;                ///< effective area of the vent times sqrt(R T), m3/s
  std::vector<double> tool_area;  ///< change of the volume per metre of each tool along the axis, m2
};

/// Value of a function and its derivative.
struct ValueAndSlope {
  double value, slope;
};

/// Outflow of p V through a vent, W, and its derivative by the pressure inside: the isentropic nozzle, choked beyond
/// the critical ratio of pressures (A. J. C. B. de Saint-Venant, L. Wantzel, J. Ecole Polytechnique 16 (1839) 85-122;
/// F. M. White, Fluid Mechanics, 7th ed. 2011, equation 9.45), and linear where the pressures differ by less than 0.1
/// %. Pressures absolute, Pa; negative where air flows in.
ValueAndSlope vent_outflow(double vent, double inside, double ambient);

/// Absolute pressure of a pocket, Pa, at the end of a step of length dt, s, that leaves it the volume V, m3, and its
/// derivative by V: p V = energy (V_n/V)^(n-1) - n dt outflow(p). Below a ten-thousandth of the volume V_n at the
/// step's start the tangent there.
ValueAndSlope pressure_at(const AirPocket& pocket, double ambient, double dt, double volume);

}  // namespace parison::flow
