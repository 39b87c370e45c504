#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "forming/solid/flow/solid_problem.hpp"

namespace parison::flow {

/// Forces on the nodes, N, three for each: of the gas on faces of the mesh, and of surface tension on open ones.
Eigen::VectorXd pressure_forces(const SolidProblem& problem, const HexMesh& mesh);
Eigen::VectorXd surface_tension_forces(const SolidProblem& problem, const HexMesh& mesh);

}  // namespace parison::flow
