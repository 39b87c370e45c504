#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "contact/conductance/conductance.hpp"

namespace parison::contact {

/// Constants of the pressure-viscosity law in the order in which fits and case files have them.
namespace law_constant {
enum : int { h0, h1, p_ref, eta_ref, a, b };
}
inline constexpr int law_constants = 6;
inline constexpr std::array<const char*, law_constants> law_constant_names{"h0", "h1", "p_ref", "eta_ref", "a", "b"};

double& constant_of(PressureViscosityConductance& law, int constant);
double constant_of(const PressureViscosityConductance& law, int constant);

/// Derivatives of h with respect to ln h0, ln h1, ln p_ref, ln eta_ref, a and b, W/m2/K.
std::array<double, law_constants> law_derivatives(const PressureViscosityConductance& law, double pressure,
                                                  double viscosity);

/// One measurement: h itself (drive 1), or a heat flux with the difference of temperature that drives it.
struct LawMeasurement {
  double pressure, viscosity;  ///< Pa, Pa.s
  double value;                ///< h, W/m2/K; or q, W/m2
  double drive = 1;            ///< K for a heat flux
};

struct LawFitOptions {
  PressureViscosityConductance fixed;  ///< values of the constants that are fixed; the others are ignored
  std::array<bool, law_constants> is_fixed{};
  bool relative = false;  ///< residuals as a share of the fitted value: for scatter that grows with the value
};

struct FittedConstant {
  double value = 0, low = 0, high = 0;  ///< with its 95 % interval; SI
  bool fixed = false;
  bool known = true;  ///< whether the data determine it; otherwise the interval means nothing
};

struct LawFit {
  PressureViscosityConductance law;
  std::array<FittedConstant, law_constants> constants;
  std::vector<double> residual;  ///< measured less fitted, or that as a share of the fitted value
  double scatter = 0;            ///< root of the sum of squares over the degrees of freedom
  int freedom = 0;               ///< degrees of freedom
  std::vector<std::string> warnings;
};

/// Least squares by Levenberg and Marquardt (Eigen) from several starts. p_ref and eta_ref form one constant, so
/// one of them must be fixed. Intervals by Student's t with the derivatives at the optimum, for h0, h1, p_ref and
/// eta_ref on a logarithmic scale. An exponent that comes out below zero is fixed at zero. Throws CaseError where there
/// are too few data.
LawFit fit_law(const std::vector<LawMeasurement>& data, const LawFitOptions& options);

/// Reads measurements from a CSV file whose headings are names with units as in a case file (`p_kPa`): `p`; `h`, or `q`
/// with `T_glass` and `T_tool`; `eta`, or `T_glass` of which `viscosity` (Pa.s, of K; may be empty) makes it; `t` is
/// read over. Throws CaseError `file:line: column "p": what was found, what is allowed`.
std::vector<LawMeasurement> read_law_data(const std::string& path, const std::function<double(double)>& viscosity);

}  // namespace parison::contact
