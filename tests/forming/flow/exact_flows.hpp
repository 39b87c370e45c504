#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow_case.hpp"

namespace parison::flow {

// Stokes flow in the unit square with slipping walls, and around an inclusion. Problems: Duretz, May, Gerya & Tackley
// (2011), Geochem. Geophys. Geosyst. 12, Q07004.

/// Viscosity 1 for x < 1/2, `jump` for x > 1/2; vertical force sin(pi y) cos(pi x).
ExactFlow sol_cx(double jump);
/// Viscosity exp(2 B y), rising by `ratio` from y = 0 to 1; vertical force sin(2 y) cos(3 pi x).
ExactFlow sol_kz(double ratio);
/// Round inclusion of viscosity `jump` and `radius` around the origin, 1 outside, pulled along x and squeezed along y
/// at the rate 1 far away (Schmid & Podladchikov 2003, Geophys. J. Int. 155, 269).
ExactFlow sol_vi(double jump, double radius);

}  // namespace parison::flow
