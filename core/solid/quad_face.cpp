// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/quad_face.hpp"

#include "core/mesh/element.hpp"

namespace parison::core {

namespace {

/// Values of edge_shape in the order of the places 0, 1/2, 1.
std::array<double, 3> along(const std::array<double, 3>& first_last_mid) {
  return {first_last_mid[0], first_last_mid[2], first_last_mid[1]};
}

}  // namespace

std::array<double, 9> quad_shape(double a, double b) {
  const auto u = along(edge_shape(a)), v = along(edge_shape(b));
  std::array<double, 9> shape;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) shape[i + 3 * j] = u[i] * v[j];
  return shape;
}

std::array<std::array<double, 2>, 9> quad_shape_derivative(double a, double b) {
  const auto u = along(edge_shape(a)), v = along(edge_shape(b));
  const auto du = along(edge_shape_derivative(a)), dv = along(edge_shape_derivative(b));
  std::array<std::array<double, 2>, 9> derivative;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) derivative[i + 3 * j] = {du[i] * v[j], u[i] * dv[j]};
  return derivative;
}

FacePlace face_place(const std::vector<Vector3>& nodes, const QuadFace& face, double a, double b) {
  const auto shape = quad_shape(a, b);
  const auto derivative = quad_shape_derivative(a, b);
  FacePlace place{Vector3::Zero(), Vector3::Zero(), Vector3::Zero()};
  for (int i = 0; i < 9; ++i) {
    const Vector3& x = nodes[face.nodes[i]];
    place.position += shape[i] * x;
    place.along_a += derivative[i][0] * x;
    place.along_b += derivative[i][1] * x;
  }
  return place;
}

QuadFace quad_face(const HexMesh& mesh, const HexFace& face, Index boundary_id) {
  QuadFace result{{}, boundary_id};
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const Vector3 at = 2 * cube_place(face, 0.5 * i, 0.5 * j);
      const int node = static_cast<int>(at[0]) + 3 * static_cast<int>(at[1]) + 9 * static_cast<int>(at[2]);
      result.nodes[i + 3 * j] = mesh.cells[face.cell][node];
    }
  return result;
}

Vector3 cube_place(const HexFace& face, double a, double b) {
  Vector3 at;
  at[face.axis] = face.end;
  at[(face.axis + 1) % 3] = face.end ? a : b;
  at[(face.axis + 2) % 3] = face.end ? b : a;
  return at;
}

}  // namespace parison::core
