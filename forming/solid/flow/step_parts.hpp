#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "forming/solid/flow/flow_matrix.hpp"

namespace parison::flow {

/// Limits of a step: solutions, factors, and the change of the friction at its limit by a solution, over all of it.
inline constexpr int most_solutions = 30, most_factors = 3;
inline constexpr double friction_tolerance = 1e-6;

/// A mesh moved by a velocity, three for each node, m/s, over a time, s.
HexMesh moved(const HexMesh& mesh, const Eigen::VectorXd& velocity, double time);
/// Whether a cell is so bad that a step has to be shorter.
bool is_folded(const HexMesh& mesh);
/// Forces, N, three for each node, of gas, surface tension and the weight of the cells' masses, kg.
Eigen::VectorXd loads(const SolidProblem& problem, const FlowMatrix& matrix, const HexMesh& mesh,
                      const Eigen::VectorXd& mass);

}  // namespace parison::flow
