#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <string>
#include <vector>

#include "forming/study/search/case/search_variable.hpp"

namespace parison::forming {

/// A constant that a fit has found, in the unit of its bounds.
struct FittedConstant {
  double value, low, high;  ///< the 95 % interval; not a number where the data cannot tell
  bool at_bound;
};

/// What a fit says of its constants.
struct FitIntervals {
  std::vector<FittedConstant> constants;
  double scatter = 0;               ///< of the data about the model, in units of the stated noise
  long freedom = 0;                 ///< rows less constants
  std::vector<std::string> cannot;  ///< sentences on directions that the data cannot tell
};

/// The 95 % intervals of constants by the linearised covariance s^2 (J^T J)^-1 and Student's t. A direction in which
/// the data let the constants move by more than their bounds are apart, the data cannot tell: it is named and left out
/// of the intervals of the others. `residual` in units of the noise, a row a measurement, and `jacobian` its derivative
/// by the coordinates at the optimum.
FitIntervals fit_intervals(const std::vector<SearchVariable>& variables, const Eigen::VectorXd& at,
                           const Eigen::VectorXd& residual, const Eigen::MatrixXd& jacobian);

}  // namespace parison::forming
