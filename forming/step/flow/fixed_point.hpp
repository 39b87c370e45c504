#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

namespace parison::forming {

/// Iterates x = G(x) where plain iteration diverges in a few directions, such as bending of a wall under pressure that
/// is faster than the step: the next x is the combination of the last ones whose residuals G(x) - x add up to least
/// (D. G. Anderson, J. ACM 12 (1965) 547-560; H. F. Walker, P. Ni, SIAM J. Numer. Anal. 49 (2011) 1715-1735).
class FixedPoint {
 public:
  /// The next x, from an x and its G(x).
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& mapped);
  /// Leaves the last ones aside, where G has changed.
  void forget();

 private:
  std::vector<Eigen::VectorXd> mapped_, residual_;
};

}  // namespace parison::forming
