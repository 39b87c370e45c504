#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "thermal/problem.hpp"
#include "thermal/time/step_matrix.hpp"

namespace parison::thermal {

/// Advances the nodal temperatures, by body, K, of a problem from `time` to `time` + dt, s, on fixed meshes: TR-BDF2
/// (Bank et al. 1985) on the enthalpy form with the embedded third-order error estimate of Hosea and Shampine (1996)
/// and substeps that meet the tolerance. Boundary values are those at the time of each stage. Prescribed temperatures
/// are imposed at `time` before the first substep. Where absorption depends on temperature and is not given, the step
/// is taken twice: with that of the start, and with that of the mean of start and end, of second order. `matrix` is
/// reused between calls.
StepOutcome advance(const Problem& problem, double time, const std::vector<Eigen::VectorXd>& temperature, double dt,
                    const StepOptions& options, StepMatrix& matrix);

}  // namespace parison::thermal
