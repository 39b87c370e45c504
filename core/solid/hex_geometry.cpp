// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/hex_geometry.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <limits>

namespace parison::core {

namespace {

constexpr int exact_points = 3;  ///< the Jacobian has degree 5 in each coordinate

}  // namespace

HexNodes cell_nodes(const HexMesh& mesh, Index cell) {
  HexNodes nodes;
  for (int n = 0; n < HexMesh::nodes_per_cell; ++n) nodes.col(n) = mesh.nodes[mesh.cells[cell][n]];
  return nodes;
}

std::array<Index, 9> face_node_numbers(const HexMesh& mesh, const HexFace& face) {
  std::array<Index, 9> numbers{};
  const auto& local = hex_face_nodes(face.axis, face.end);
  for (int n = 0; n < 9; ++n) numbers[n] = mesh.cells[face.cell][local[n]];
  return numbers;
}

HexFaceNodes face_nodes(const HexMesh& mesh, const HexFace& face) {
  HexFaceNodes nodes;
  const auto numbers = face_node_numbers(mesh, face);
  for (int n = 0; n < 9; ++n) nodes.col(n) = mesh.nodes[numbers[n]];
  return nodes;
}

Eigen::VectorXd cell_volumes(const HexMesh& mesh) {
  const HexRule& rule = hex_rule(exact_points, exact_points);
  Eigen::VectorXd volume = Eigen::VectorXd::Zero(mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const HexNodes nodes = cell_nodes(mesh, cell);
    for (std::size_t q = 0; q < rule.at.size(); ++q)
      volume[cell] += rule.weight[q] * (nodes * rule.derivative[q].transpose()).determinant();
  }
  return volume;
}

double least_jacobian(const HexMesh& mesh, Index cell) {
  static const std::vector<HexGradient> at_nodes = [] {
    std::vector<HexGradient> all;
    for (int n = 0; n < HexMesh::nodes_per_cell; ++n)
      all.push_back(hex_shape_derivative({0.5 * (n % 3), 0.5 * (n / 3 % 3), 0.5 * (n / 9)}));
    return all;
  }();
  const HexNodes nodes = cell_nodes(mesh, cell);
  const auto jacobian = [&](const HexGradient& derivative) { return (nodes * derivative.transpose()).determinant(); };
  const double centre = jacobian(hex_shape_derivative({0.5, 0.5, 0.5}));
  if (!(centre > 0)) return -std::numeric_limits<double>::infinity();
  double least = centre;
  for (const HexGradient& derivative : hex_rule(exact_points, exact_points).derivative)
    least = std::min(least, jacobian(derivative));
  const auto& own = mesh.cells[cell];
  for (std::size_t n = 0; n < own.size(); ++n)
    if (std::count(own.begin(), own.end(), own[n]) == 1) least = std::min(least, jacobian(at_nodes[n]));
  return least / centre;
}

}  // namespace parison::core
