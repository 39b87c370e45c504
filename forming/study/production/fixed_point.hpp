#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <functional>
#include <optional>

namespace parison::forming {

/// A map of vectors; nothing where it cannot be evaluated.
using VectorMap = std::function<std::optional<Eigen::VectorXd>(const Eigen::VectorXd&)>;

struct FixedPointOptions {
  double tolerance;     ///< of the size of x - map(x)
  int depth;            ///< of Anderson's acceleration
  int delay;            ///< plain iterations before it
  int max_evaluations;  ///< of the map
  std::function<double(const Eigen::VectorXd& change)> size;
};

struct FixedPointOutcome {
  bool converged = false;
  int evaluations = 0;
  double change = 0;      ///< size of the last x - map(x)
  Eigen::VectorXd value;  ///< the last map(x)
};

/// Looks for x = map(x) by the fixed-point iteration of SUNDIALS KINSOL with Anderson's acceleration (D. G. Anderson,
/// J. ACM 12 (1965) 547-560; H. F. Walker, P. Ni, SIAM J. Numer. Anal. 49 (2011) 1715-1735). Where that leads
/// away it begins anew from the best so far. It stops at the first x that meets the tolerance and where the map cannot
/// be evaluated.
FixedPointOutcome find_fixed_point(const Eigen::VectorXd& start, const VectorMap& map,
                                   const FixedPointOptions& options);

}  // namespace parison::forming
