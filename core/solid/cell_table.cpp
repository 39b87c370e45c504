// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/cell_table.hpp"

#include <Eigen/LU>

#include "core/mesh/element.hpp"
#include "core/solid/prism_mesh.hpp"

namespace parison::core {

namespace {

/// Shape functions and derivatives at the places 0, 1/2, 1 of a unit interval.
struct Line {
  std::array<double, 3> shape, derivative;
};
Line line(double s) {
  const auto shape = edge_shape(s), derivative = edge_shape_derivative(s);
  return {{shape[0], shape[2], shape[1]}, {derivative[0], derivative[2], derivative[1]}};
}

CellTable empty_table(Index points, Index nodes) {
  return {Eigen::MatrixXd(points, nodes), Eigen::MatrixXd(3 * points, nodes), Eigen::VectorXd(points)};
}

CellTable make_hexahedron_table() {
  CellTable table = empty_table(27, HexMesh::nodes_per_cell);
  const auto& rule = edge_rule(3);
  for (int q = 0; q < 27; ++q) {
    const auto &a = rule[q % 3], &b = rule[q / 3 % 3], &c = rule[q / 9];
    const Line u = line(a.s), v = line(b.s), w = line(c.s);
    table.weight[q] = a.weight * b.weight * c.weight;
    for (int n = 0; n < HexMesh::nodes_per_cell; ++n) {
      const int i = n % 3, j = n / 3 % 3, k = n / 9;
      table.shape(q, n) = u.shape[i] * v.shape[j] * w.shape[k];
      table.derivative(3 * q, n) = u.derivative[i] * v.shape[j] * w.shape[k];
      table.derivative(3 * q + 1, n) = u.shape[i] * v.derivative[j] * w.shape[k];
      table.derivative(3 * q + 2, n) = u.shape[i] * v.shape[j] * w.derivative[k];
    }
  }
  return table;
}

CellTable make_prism_table() {
  CellTable table = empty_table(18, PrismMesh::nodes_per_cell);
  const auto& triangle = triangle_rule(4);
  const auto& rule = edge_rule(3);
  for (int q = 0; q < 18; ++q) {
    const auto& at = triangle[q % 6];
    const auto shape = triangle_shape(at.a, at.b);
    const auto derivative = triangle_shape_derivative(at.a, at.b);
    const Line w = line(rule[q / 6].s);
    table.weight[q] = at.weight * rule[q / 6].weight;
    for (int n = 0; n < PrismMesh::nodes_per_cell; ++n) {
      const int i = n % 6, k = n / 6;
      table.shape(q, n) = shape[i] * w.shape[k];
      table.derivative(3 * q, n) = derivative[i][0] * w.shape[k];
      table.derivative(3 * q + 1, n) = derivative[i][1] * w.shape[k];
      table.derivative(3 * q + 2, n) = shape[i] * w.derivative[k];
    }
  }
  return table;
}

/// Calls visit(column, weight, Jacobian) for every point; row d of the Jacobian is dx/d(reference d).
template <typename Visit>
void for_each_point(const std::vector<Vector3>& nodes, const CellList& cells, const Visit& visit) {
  const CellTable& table = *cells.table;
  Eigen::Matrix<double, Eigen::Dynamic, 3> x(table.nodes(), 3), jacobian(3 * table.points(), 3);
  for (Index c = 0; c < cells.count; ++c) {
    const Index* cell = cells.cell(c);
    for (Index n = 0; n < table.nodes(); ++n) x.row(n) = nodes[cell[n]].transpose();
    jacobian.noalias() = table.derivative * x;
    for (Index q = 0; q < table.points(); ++q)
      visit(c * table.points() + q, table.weight[q], Eigen::Matrix3d(jacobian.middleRows<3>(3 * q)));
  }
}

}  // namespace

const CellTable& hexahedron_table() {
  static const CellTable table = make_hexahedron_table();
  return table;
}

const CellTable& prism_table() {
  static const CellTable table = make_prism_table();
  return table;
}

CellMetric cell_metric(const std::vector<Vector3>& nodes, const CellList& cells) {
  CellMetric metric{Eigen::VectorXd(cells.point_count()), {}};
  metric.gradient.setZero(6, cells.point_count());
  for_each_point(nodes, cells, [&](Index column, double weight, const Eigen::Matrix3d& jacobian) {
    metric.volume[column] = weight * jacobian.determinant();
    if (!(metric.volume[column] > 0)) return;
    // The gradient in space is J^-1 times that in the cell.
    const Eigen::Matrix3d inverse = jacobian.inverse();
    const Eigen::Matrix3d product = metric.volume[column] * inverse.transpose() * inverse;
    metric.gradient.col(column) << product(0, 0), product(0, 1), product(0, 2), product(1, 1), product(1, 2),
        product(2, 2);
  });
  return metric;
}

Eigen::VectorXd point_volumes(const std::vector<Vector3>& nodes, const CellList& cells) {
  Eigen::VectorXd volume(cells.point_count());
  for_each_point(nodes, cells, [&](Index column, double weight, const Eigen::Matrix3d& jacobian) {
    volume[column] = weight * jacobian.determinant();
  });
  return volume;
}

}  // namespace parison::core
