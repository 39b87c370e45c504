#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "forming/study/uncertainty/chaos.hpp"

namespace parison::forming {

/// A number with the interval that holds the true one in 95 %.
struct Interval {
  double value = 0, low = 0, high = 0;
};

/// Variances by their causes, free of the share that the noise of the runs has in them, and main effects.
struct VarianceParts {
  double whole = 0;              ///< of all tolerances together
  Eigen::VectorXd first, total;  ///< of each variable alone; of all terms that it is in
  Eigen::VectorXd main_effect;   ///< half the change from one standard deviation below the mean to one above
};

/// What the tolerances do to a quantity, by its surrogate.
struct Effects {
  VarianceParts found;
  std::vector<VarianceParts> resampled;  ///< by bootstrap, all quantities of the same runs with the same draws
  double mean = 0;                       ///< over the tolerances
  double unexplained = 0;                ///< variance at unseen runs that is neither the surrogate nor noise
  double unseen = 0, variance = 0;       ///< mean square of the errors at unseen runs; variance of the runs
  double by_chance = 0;                  ///< share of the variance that a chosen term may explain without any effect
  std::size_t runs = 0;

  double q2() const { return variance > 0 ? 1 - unseen / variance : 0; }
};

/// Whether tolerances do anything that shows above the noise: at unseen runs the surrogate explains more than the best
/// of so many terms would by chance, 2 ln(terms)/runs (D. L. Donoho, I. M. Johnstone, Biometrika 81 (1994) 425-455, eq.
/// 9).
bool has_effect(const Effects& effects);

/// Fits a surrogate and takes it apart (B. Sudret, Reliab. Eng. Syst. Saf. 93 (2008) 964-979, section 3.4). `noise` is
/// the variance that runs have without any tolerance, at least; it belongs to no variable. The bootstrap draws
/// residuals of runs that the surrogate has not seen (B. Efron, R. Tibshirani, An Introduction to the Bootstrap, 1993,
/// section 9.4).
Effects find_effects(const ChaosBasis& basis, const std::vector<StandardScatter>& scatters,
                     const std::vector<Eigen::Index>& runs, const Eigen::VectorXd& values, double noise,
                     std::uint64_t seed);

/// The effects on several quantities together, such as all places of a wall: their variances added, which gives the
/// generalised indices (M. Lamboni, H. Monod, D. Makowski, Reliab. Eng. Syst. Saf. 96 (2011) 450-459, section 2.3).
Effects sum_of(const std::vector<Effects>& all);

/// Sobol indices with intervals by bootstrap, widened by the share of the variance that the surrogate does not explain:
/// any variable may have all of that or none of it.
struct SobolIndices {
  std::vector<Interval> first, total;
};
SobolIndices sobol_indices(const Effects& effects);

/// The standard deviation that the tolerances give a quantity, what the surrogate does not explain included.
Interval deviation(const Effects& effects);

/// The main effect of each variable, in the unit of the quantity, with intervals that are wider by what the surrogate
/// does not explain.
std::vector<Interval> main_effects(const Effects& effects);

}  // namespace parison::forming
