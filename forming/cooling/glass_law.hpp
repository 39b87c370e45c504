#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>

namespace parison::cooling {

/// Branches of a spectrum of relaxation times.
inline constexpr int branches = 6;
/// One number for each branch.
using Branches = Eigen::Array<double, branches, 1>;

/// Relaxation after a jump, sum of weight exp(-t/time): weights with the sum 1, times over those of viscosity by shear
/// modulus.
struct Spectrum {
  Branches weight, time;

  /// Mean of the times: 1 in shear, so that viscosity and spectrum agree.
  double mean() const { return (weight * time).sum(); }
};

/// Glass from the melt to the solid. Shear relaxes in Maxwell branches on reduced time (E. H. Lee, T. G. Rogers, T. C.
/// Woo, J. Am. Ceram. Soc. 48 (1965) 480-487), the bulk is elastic, and the structure follows the temperature as
/// fictive temperatures of branches (O. S. Narayanaswamy, J. Am. Ceram. Soc. 54 (1971) 491-498; C. T. Moynihan et al.,
/// J. Am. Ceram. Soc. 59 (1976) 12-16). One viscosity gives the pace of both.
struct GlassLaw {
  double young;                                   ///< Pa
  double poisson;                                 ///< of the solid
  double solid_expansion;                         ///< linear, with the structure frozen, 1/K
  double liquid_expansion;                        ///< linear, with the structure in equilibrium, 1/K
  Spectrum shear, structure;                      ///< of stress, of the fictive temperature
  double frozen_activation;                       ///< of flow with the structure frozen, over the gas constant, K
  std::function<double(double)> log_equilibrium;  ///< ln of the viscosity, Pa.s, in equilibrium over temperature, K

  double shear_modulus() const { return young / (2 * (1 + poisson)); }     ///< Pa
  double bulk_modulus() const { return young / (3 * (1 - 2 * poisson)); }  ///< Pa
  /// ln of the viscosity, Pa.s: that of equilibrium at the fictive temperature, and Arrhenius' law from there (O. V.
  /// Mazurin, J. Non-Cryst. Solids 25 (1977) 129-169); with Arrhenius' law in equilibrium it is Narayanaswamy's.
  double log_viscosity(double temperature, double fictive) const {
    return log_equilibrium(fictive) + frozen_activation * (1 / temperature - 1 / fictive);
  }
};

/// What a step does at a material point whose temperature changes and whose shape is strained at constant rates.
struct Relaxation {
  Branches kept;     ///< share of the stress at the start that each branch still has at the end
  Branches modulus;  ///< by which a branch answers the strain of the step: stress over 2 de, Pa
  Branches fictive;  ///< temperatures at the end, K
  double strain;     ///< linear, thermal, over the step
};

/// Relaxation over a step of dt, s, in which the temperature goes from `from` to `to`, K, and the fictive temperatures
/// begin at `fictive`, K. Exact for a linear temperature and a viscosity that is constant; the step is divided so that
/// the viscosity hardly changes in a part, which is of second order.
Relaxation relax(const GlassLaw& law, const Branches& fictive, double from, double to, double dt);

/// By how much a change of temperature counts for more than itself in a cell that relaxes within a step, because there
/// it decides what stress stays. `points`: of the cell, so many.
double weight_of_change(const GlassLaw& law, const Relaxation* points, int count);

}  // namespace parison::cooling
