#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "core/solid/hex_mesh.hpp"

namespace parison::core {

/// A face of a body's surface: node i + 3 j is at (a, b) = (i, j) / 2. The derivative of the position with respect to
/// a, times that with respect to b, points out of the body. Nodes may coincide on the axis.
struct QuadFace {
  std::array<Index, 9> nodes;
  Index boundary_id = 0;  ///< which part of the boundary, as the body's owner counts them
};

/// Quadratic shape functions of a face at (a, b), each in [0, 1], in the order of its nodes.
std::array<double, 9> quad_shape(double a, double b);
/// Their derivatives with respect to a and b, [node][direction].
std::array<std::array<double, 2>, 9> quad_shape_derivative(double a, double b);

/// Position, m, at a place of a face, and its derivatives with respect to a and b.
struct FacePlace {
  Vector3 position, along_a, along_b;
  Vector3 area() const { return along_a.cross(along_b); }  ///< outward, m2 per unit of a and b
};
FacePlace face_place(const std::vector<Vector3>& nodes, const QuadFace& face, double a, double b);

/// The face of a cell with its nodes ordered as QuadFace demands: a and b are the coordinates axis + 1 and axis + 2 of
/// the cube (cyclic) where `end` is 1, the other way round where it is 0.
QuadFace quad_face(const HexMesh& mesh, const HexFace& face, Index boundary_id = 0);
/// Where a place of such a face is in the unit cube of its cell.
Vector3 cube_place(const HexFace& face, double a, double b);

}  // namespace parison::core
