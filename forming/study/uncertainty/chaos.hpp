#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "forming/study/uncertainty/standard_scatter.hpp"

namespace parison::forming {

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

}  // namespace parison::forming
