#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "thermal/problem.hpp"

namespace parison::thermal {

/// How wrong the heat that light carries is.
struct LightError {
  double power = 0;     ///< of the flows to air, other surfaces and partners, their magnitudes in sum, W
  double all_heat = 0;  ///< magnitudes of all heat flows of the bodies, by light or otherwise, in sum, W
};

/// From four parts of the rays, each with its own views and exchange factors, at a time, s, and temperatures by body,
/// K: the standard deviation of each flow between the parts. Independent rays would make that twice the standard error
/// of all; the error of low-discrepancy rays is smaller. Divisions into zones and patches are the same in all parts.
LightError light_error(Problem problem, double time, const std::vector<Eigen::VectorXd>& temperature);

}  // namespace parison::thermal
