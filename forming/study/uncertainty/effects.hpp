#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/case/tolerance.hpp"

namespace parison::forming {

/// How a toleranced value scatters about its mean, in standard deviations, within the range that its key allows.
struct StandardScatter {
  core::Distribution distribution = core::Distribution::normal;
  double low = -4, high = 4;
};

/// The widest range that is looked at: four standard deviations of normal, the whole width of uniform scatter.
StandardScatter full_range(core::Distribution distribution);

/// The value, in standard deviations, that a share of all values lies below.
double quantile(const StandardScatter& scatter, double share);

/// Polynomials of degrees 0, 1, ... that are orthonormal for a scatter, whatever its range: of a whole normal one those
/// of Hermite, of a uniform one those of Legendre. By the procedure of Stieltjes (W. Gautschi, SIAM J. Sci. Stat.
/// Comput. 3 (1982) 289-317, section 2.2) on a fine midpoint rule.
class OrthonormalPolynomials {
 public:
  OrthonormalPolynomials(const StandardScatter& scatter, int highest_degree);

  /// The values of all degrees at a place.
  std::vector<double> operator()(double at) const;

 private:
  std::vector<double> alpha_, root_beta_;  ///< of the three-term recurrence
};

/// A product of orthonormal polynomials: the degree in each variable.
using ChaosTerm = std::vector<int>;

/// The terms that a surrogate may use, with their values at the runs.
struct ChaosBasis {
  std::vector<ChaosTerm> terms;                     ///< the constant first, then by rising order
  std::vector<std::size_t> levels;                  ///< how many of the first terms each order has
  Eigen::MatrixXd values;                           ///< a row a run, a column a term
  std::vector<OrthonormalPolynomials> polynomials;  ///< of each variable
};

/// Terms of up to three variables in the hyperbolic order (G. Blatman, B. Sudret, J. Comput. Phys. 230 (2011)
/// 2345-2367, eq. 22, q = 0.75) up to 12, so many that they are not more than three times the runs. `places` has a row
/// a run, in standard deviations.
ChaosBasis chaos_basis(const std::vector<StandardScatter>& scatters, const Eigen::MatrixXd& places);

/// A polynomial chaos expansion of a quantity by least squares with few of the terms of a basis.
struct Surrogate {
  std::vector<std::size_t> terms;  ///< of the basis; the constant first
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd solution;   ///< coefficients are this times the values of the runs
  Eigen::VectorXd residuals;  ///< at each run, of a surrogate without that run
  double variance = 0;        ///< of what it leaves of the runs that made it
  double unseen = 0;          ///< mean square of what it leaves of runs that it has not seen

  /// The share of the noise that a squared coefficient has, as a multiple of the noise's variance.
  double noise_gain(std::size_t term) const { return solution.row(static_cast<Eigen::Index>(term)).squaredNorm(); }
};

/// Chooses terms one by one, each time the one that explains the most of the rest (orthogonal least squares: S. Chen,
/// S. A. Billings, W. Luo, Int. J. Control 50 (1989) 1873-1896, section 3.3), order and number of terms by ten-fold
/// cross-validation, in which the choice is made again for each fold, so that the held-out runs have had no part in it.
/// `runs` are the rows of the basis that `values` are of.
Surrogate fit_surrogate(const ChaosBasis& basis, const std::vector<Eigen::Index>& runs, const Eigen::VectorXd& values);

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
