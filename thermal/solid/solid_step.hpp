#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "thermal/solid/solid_matrix.hpp"
#include "thermal/time/substeps.hpp"

namespace parison::thermal {

/// Advances the nodal temperatures, by body, K, of a problem in space from `time` to `time` + dt, s, on fixed meshes,
/// with the method, error control and balance of the advance in the plane: TR-BDF2 with the embedded estimate. The
/// stages are solved by modified Newton with Anderson's acceleration. `matrix` is reused between calls.
StepOutcome advance(const SolidProblem& problem, double time, const std::vector<Eigen::VectorXd>& temperature,
                    double dt, const StepOptions& options, SolidStepMatrix& matrix);

}  // namespace parison::thermal
