// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/flow/surface_loads.hpp"

#include "core/solid/hex_geometry.hpp"

namespace parison::flow {

namespace {

/// Adds to the nodes of a face what `force` (3 x 9) makes of each of its points.
template <class Force>
void add_face(const HexMesh& mesh, const HexFace& face, const Force& force, Eigen::VectorXd& forces) {
  Eigen::Matrix<double, 3, 9> sum = Eigen::Matrix<double, 3, 9>::Zero();
  for (const core::HexFacePoint& point : core::map_hex_face(core::face_nodes(mesh, face), face, points_along))
    sum += force(point);
  const auto numbers = core::face_node_numbers(mesh, face);
  for (int n = 0; n < 9; ++n) forces.segment<3>(3 * numbers[n]) += sum.col(n);
}

}  // namespace

Eigen::VectorXd pressure_forces(const SolidProblem& problem, const HexMesh& mesh) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * mesh.node_count());
  for (const auto& [faces, pressure] : problem.pressures) {
    if (pressure == 0) continue;
    for (const HexFace& face : faces)
      add_face(
          mesh, face,
          [p = pressure](const core::HexFacePoint& at) -> Eigen::Matrix<double, 3, 9> {
            return -p * at.area * at.normal * at.shape.transpose();
          },
          forces);
  }
  return forces;
}

/// -int sigma div_S u dA: with the gradients in the face, without its curvature (K. J. Ruschak, Int. J. Numer. Meth.
/// Engng 15 (1980) 639-648).
Eigen::VectorXd surface_tension_forces(const SolidProblem& problem, const HexMesh& mesh) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(3 * mesh.node_count());
  const double tension = problem.material->surface_tension;
  if (tension == 0) return forces;
  for (const HexFace& face : problem.open_faces)
    add_face(
        mesh, face,
        [tension](const core::HexFacePoint& at) -> Eigen::Matrix<double, 3, 9> {
          return -tension * at.area * at.gradient;
        },
        forces);
  return forces;
}

}  // namespace parison::flow
