#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <variant>
#include <vector>

namespace parison::contact {

/// h whatever the pressure and the viscosity.
struct ConstantConductance {
  double h;  ///< W/m2/K
};

/// h = h0 + (h1 - h0) x/(1 + x), x = (p/p_ref)^a (eta_ref/eta)^b (assumed, inside the published band).
struct PressureViscosityConductance {
  double h0 = 500, h1 = 20000;  ///< W/m2/K
  double p_ref = 0.2e6;         ///< Pa
  double eta_ref = 1e3;         ///< Pa.s
  double a = 1, b = 0.25;
};

/// Bilinear over log p and log eta, ends held.
struct TableConductance {
  std::vector<double> pressure, viscosity;  ///< Pa, Pa.s; strictly increasing
  std::vector<double> h;                    ///< W/m2/K, h[i * viscosity.size() + j]
};

using ConductanceLaw = std::variant<ConstantConductance, PressureViscosityConductance, TableConductance>;

/// h and its derivatives; `outside` where a table had to hold its end.
struct ConductanceValue {
  double h, dh_dp, dh_deta;
  bool outside = false;
};
ConductanceValue conductance(const ConductanceLaw& law, double pressure, double viscosity);

/// The largest value that a law can give, W/m2/K.
double highest(const ConductanceLaw& law);

}  // namespace parison::contact
