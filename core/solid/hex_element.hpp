#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/solid/hex_mesh.hpp"

namespace parison::core {

/// A value at each node of a cell, and its gradient, a column for each node.
using HexShape = Eigen::Matrix<double, 27, 1>;
using HexGradient = Eigen::Matrix<double, 3, 27>;
/// Positions of the nodes of a cell, m, a column for each.
using HexNodes = Eigen::Matrix<double, 3, 27>;

/// Point and weight of a rule on [0, 1].
struct LineRulePoint {
  double at, weight;
};
/// Gauss-Legendre rule on [0, 1] with any number of points, exact to degree 2 points - 1.
std::vector<LineRulePoint> gauss_rule(int points);

/// Quadratic shape functions of [0, 1] with nodes at 0, 1/2 and 1, and their derivatives.
std::array<double, 3> line_shape(double at);
std::array<double, 3> line_shape_derivative(double at);

/// Shape functions of the 27-node hexahedron at a point of the unit cube, in the order of HexMesh::cells.
HexShape hex_shape(const Vector3& at);
/// Their derivatives with respect to the cube's coordinates.
HexGradient hex_shape_derivative(const Vector3& at);

/// A product rule on the unit cube with the shape functions at its points.
struct HexRule {
  std::vector<Vector3> at;
  std::vector<double> weight;
  Eigen::Matrix<double, 27, Eigen::Dynamic> shape;  ///< a column for each point
  std::vector<HexGradient> derivative;
};
/// Of Gauss points, so many along the first two coordinates of the cube and `across` along the third; kept.
const HexRule& hex_rule(int along, int across);

/// A point of a cell in space.
struct HexPoint {
  HexGradient gradient;  ///< of the shape functions, 1/m
  double volume;         ///< weight times the Jacobian, m3; not positive where the cell is inverted
};
HexPoint map_hex_point(const HexNodes& nodes, const HexRule& rule, std::size_t point);

/// The nodes of a face in their cell: entry a + 3 b is at (a, b)/2 along the face's own two coordinates. These are the
/// cell's two other axes in ascending order.
const std::array<int, 9>& hex_face_nodes(int axis, int end);

/// A point of a face in space.
struct HexFacePoint {
  Eigen::Matrix<double, 9, 1> shape;  ///< in the order of hex_face_nodes
  /// In the plane of the face, of each shape function, 1/m.
  Eigen::Matrix<double, 3, 9> gradient;
  Vector3 position;  ///< m
  Vector3 normal;    ///< unit, out of the cell
  double area;       ///< weight times the measure, m2
};
using HexFaceNodes = Eigen::Matrix<double, 3, 9>;
/// The points of the Gauss rule with `points` x `points` on a face; point a + points b is at the rule's (a, b).
std::vector<HexFacePoint> map_hex_face(const HexFaceNodes& nodes, const HexFace& face, int points);

}  // namespace parison::core
