#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
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

}  // namespace parison::forming
