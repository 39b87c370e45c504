// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/transfer.hpp"

#include <algorithm>

#include "core/cholesky.hpp"
#include "core/element.hpp"
#include "remesh/cell_grid.hpp"
#include "remesh/overlay.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

/// Of the quadratic functions of the nodes, or of the linear ones of the vertices.
core::Assembly mass_matrix(const Mesh& mesh, core::Geometry geometry, int order) {
  const Index n = order == 2 ? 6 : 3;
  core::Cliques cliques;
  for (const auto& cell : mesh.cells) cliques.add(cell.data(), n);
  core::Assembly mass = core::make_assembly(order == 2 ? mesh.node_count() : mesh.vertex_count, cliques);
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    std::array<double, 36> local{};
    for (const core::TriangleRulePoint& at : core::triangle_rule(6)) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, at);
      const double* shape = order == 2 ? point.shape.data() : point.linear.data();
      for (int i = 0; i < n; ++i)
        for (int j = 0; j <= i; ++j) local[n * i + j] += shape[i] * shape[j] * point.volume;
    }
    core::add_clique(mass.matrix, mass.scatter, cell, n, local.data());
  }
  return mass;
}

/// Holds each value within the old nodal range of the cell it comes from, widened by half on both sides where that brings
/// no new extreme: quadratic fields pass, overshoots next to a thermal skin do not.
void bound(const Mesh& from, const Transfer& transfer, const Eigen::VectorXd& nodal, Eigen::VectorXd& value) {
  const double lowest = nodal.minCoeff(), highest = nodal.maxCoeff();
  for (Index i = 0; i < value.size(); ++i) {
    const auto& cell = from.cells[transfer.cell[i]];
    double low = nodal[cell[0]], high = low;
    for (const Index node : cell) low = std::min(low, nodal[node]), high = std::max(high, nodal[node]);
    const double slack = 0.5 * (high - low);
    value[i] = std::clamp(value[i], std::max(lowest, low - slack), std::min(highest, high + slack));
  }
}

/// Moves all values by a share of their way to the highest or lowest old one until the volume mean is the wanted one.
void restore_mean(const Eigen::VectorXd& weight, double wanted, double lowest, double highest, Eigen::VectorXd& value) {
  const double volume = weight.sum();
  for (int pass = 0; pass < 3; ++pass) {
    const double defect = -weight.dot((value.array() - wanted).matrix()) / volume;
    const double limit = defect > 0 ? highest : lowest;
    const double room = limit - wanted + defect;
    if (defect == 0 || room == 0) break;
    const double share = std::clamp(defect / room, 0.0, 1.0);
    value = value.unaryExpr([&](double old) { return std::clamp(old + share * (limit - old), lowest, highest); });
  }
}

}  // namespace

Transfer make_transfer(const Mesh& from, const Mesh& to) {
  const CellGrid grid(from);
  Transfer transfer;
  transfer.cell.reserve(to.nodes.size());
  transfer.at.reserve(to.nodes.size());
  for (const Point& x : to.nodes) {
    const CellGrid::Found found = grid.find(x);
    transfer.cell.push_back(found.cell);
    transfer.at.push_back(found.at);
  }
  return transfer;
}

Eigen::VectorXd interpolate(const Mesh& from, const Transfer& transfer, const Eigen::VectorXd& nodal) {
  Eigen::VectorXd result(transfer.cell.size());
  for (Index i = 0; i < result.size(); ++i) {
    const auto shape = core::triangle_shape(transfer.at[i][0], transfer.at[i][1]);
    result[i] = 0;
    for (int k = 0; k < 6; ++k) result[i] += shape[k] * nodal[from.cells[transfer.cell[i]][k]];
  }
  return result;
}

double mean(const Mesh& mesh, core::Geometry geometry, const Eigen::VectorXd& nodal) {
  // Relative to one value, so that a uniform field has its own value as the mean.
  const double base = nodal[0];
  double content = 0, volume = 0;
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const core::TriangleRulePoint& at : core::triangle_rule(6)) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, at);
      double value = 0;
      for (int k = 0; k < 6; ++k) value += point.shape[k] * (nodal[mesh.cells[cell][k]] - base);
      content += value * point.volume;
      volume += point.volume;
    }
  return base + content / volume;
}

Eigen::VectorXd transfer_conserving(const Mesh& from, const Mesh& to, core::Geometry geometry, const Transfer& transfer,
                                    const Eigen::VectorXd& nodal, int order) {
  const core::Assembly mass = mass_matrix(to, geometry, order);
  core::Cholesky factor;
  factor.analyse(mass.matrix);
  Eigen::VectorXd result;
  if (factor.factorise(mass.matrix)) {
    const Eigen::VectorXd load = overlay_load(from, to, geometry, nodal);
    result = factor.solve(order == 2 ? load : core::to_vertices(to, load));
  } else {
    result = interpolate(from, transfer, nodal).head(mass.matrix.size);
  }
  bound(from, transfer, nodal, result);
  const Eigen::VectorXd weight = core::multiply(mass.matrix, Eigen::VectorXd::Ones(mass.matrix.size));
  restore_mean(weight, mean(from, geometry, nodal), nodal.minCoeff(), nodal.maxCoeff(), result);
  return order == 2 ? result : core::from_vertices(to, result);
}

}  // namespace parison::remesh
