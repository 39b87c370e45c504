#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <string>
#include <vector>

#include "thermal/heat_balance.hpp"
#include "thermal/problem.hpp"
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

/// Error control of TR-BDF2.
struct StepOptions {
  double tolerance = 0.1;           ///< max estimated local error of a substep at any node, K
  double newton_tolerance = 1e-10;  ///< max algebraic error of a stage at any node, K
  double initial_substep = 0;       ///< s; 0: the whole step
  double max_substep = std::numeric_limits<double>::infinity();  ///< s
  double min_substep = 1e-12;                                    ///< s; the step fails where less would be needed
};

/// Result of a step; when it did not converge, temperature and balance are those after the last accepted substep.
struct StepOutcome {
  bool converged = false;
  std::string reason;                        ///< why it did not converge
  std::vector<Eigen::VectorXd> temperature;  ///< by body and node, K
  HeatBalance balance;                       ///< over the step
  double next_substep = 0;                   ///< proposed initial substep of the next call, s
  Index substeps = 0, rejected = 0, factorisations = 0, solves = 0;
};

/// Advances the nodal temperatures, by body, K, of a problem from `time` to `time` + dt, s, on fixed meshes: TR-BDF2
/// (Bank et al. 1985) on the enthalpy form with the embedded third-order error estimate of Hosea and Shampine (1996)
/// and substeps that meet the tolerance. Boundary values are those at the time of each stage. Prescribed temperatures
/// are imposed at `time` before the first substep. Where absorption depends on temperature and is not given, the step
/// is taken twice: with that of the start, and with that of the mean of start and end, of second order. `matrix` is
/// reused between calls.
StepOutcome advance(const Problem& problem, double time, const std::vector<Eigen::VectorXd>& temperature, double dt,
                    const StepOptions& options, StepMatrix& matrix);

}  // namespace parison::thermal
