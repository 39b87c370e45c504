// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/flow/step_parts.hpp"

#include "core/solid/hex_geometry.hpp"
#include "forming/solid/flow/surface_loads.hpp"

namespace parison::flow {

HexMesh moved(const HexMesh& mesh, const Eigen::VectorXd& velocity, double time) {
  HexMesh result = mesh;
  for (Index node = 0; node < mesh.node_count(); ++node) result.nodes[node] += time * velocity.segment<3>(3 * node);
  return result;
}

bool is_folded(const HexMesh& mesh) {
  constexpr double least_shape = 0.02;  // least Jacobian of a cell over that at its centre
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    if (core::least_jacobian(mesh, cell) < least_shape) return true;
  return false;
}

Eigen::VectorXd loads(const SolidProblem& problem, const FlowMatrix& matrix, const HexMesh& mesh,
                      const Eigen::VectorXd& mass) {
  Eigen::VectorXd force = pressure_forces(problem, mesh) + surface_tension_forces(problem, mesh);
  if (problem.gravity != 0) force += matrix.weight(problem.gravity, mass);
  return force;
}

}  // namespace parison::flow
