#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <string>
#include <vector>

#include "thermal/heat_balance.hpp"
#include "thermal/problem.hpp"
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

struct StepOptions {
  double tolerance = 0.1;           ///< largest estimated local error of a substep at any node, K
  double newton_tolerance = 1e-10;  ///< largest error left in the equations of a stage at any node, K
  double initial_substep = 0;       ///< s; 0: the whole step
  double max_substep = std::numeric_limits<double>::infinity();  ///< s
  double min_substep = 1e-12;                                    ///< s; needing less is a failure
};

/// Result of a step; when it did not converge, temperature and balance stand where the last good substep ended.
struct StepOutcome {
  bool converged = false;
  std::string reason;
  std::vector<Eigen::VectorXd> temperature;  ///< per body and node, K
  HeatBalance balance;                       ///< over the step
  double next_substep = 0;                   ///< what the next call should start with, s
  Index substeps = 0, rejected = 0, factorisations = 0, solves = 0;
};

/// Advances all bodies by dt with the meshes where they are: TR-BDF2 on enthalpy (Bank et al. 1985) with the embedded
/// third-order estimate (Hosea and Shampine 1996), substeps as the tolerance asks. `matrix` is kept between calls.
StepOutcome advance(const Problem& problem, const std::vector<Eigen::VectorXd>& temperature, double dt,
                    const StepOptions& options, StepMatrix& matrix);

}  // namespace parison::thermal
