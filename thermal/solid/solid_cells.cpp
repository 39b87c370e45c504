// SPDX-License-Identifier: GPL-3.0-or-later
#include "thermal/solid/solid_cells.hpp"

#include <algorithm>

namespace parison::thermal {

namespace {

using Eigen::MatrixXd;

constexpr Index block = 16;  ///< cells that share a matrix product

/// Nodal temperatures of some cells, one column each.
void gather(const SolidLaws& body, const Eigen::VectorXd& temperature, Index first, Index count, MatrixXd& local) {
  const Index nodes = body.cells.table->nodes();
  local.resize(nodes, count);
  for (Index c = 0; c < count; ++c) {
    const Index* cell = body.cells.cell(first + c);
    for (Index n = 0; n < nodes; ++n) local(n, c) = temperature[body.first_unknown + cell[n]];
  }
}

double conductivity_at(const SolidLaws& body, Index point, double T) {
  return body.thin_wall.size() > 0 ? body.conductivity(T, body.thin_wall[point]) : body.conductivity(T);
}

/// Conductivity times the symmetric metric of a point times a gradient in the cell, with the sign of `factor`.
void conduct(const SolidLaws& body, Index point, double factor, const double* gradient, double* flux) {
  const double* m = &body.metric.gradient(0, point);
  const double x = factor * gradient[0], y = factor * gradient[1], z = factor * gradient[2];
  flux[0] = m[0] * x + m[1] * y + m[2] * z;
  flux[1] = m[1] * x + m[3] * y + m[4] * z;
  flux[2] = m[2] * x + m[4] * y + m[5] * z;
}

}  // namespace

void add_cells(const SolidLaws& body, const Eigen::VectorXd& temperature, Response& response) {
  const core::CellTable& table = *body.cells.table;
  const Index nodes = table.nodes(), points = table.points();
  const Eigen::VectorXd& mass = *body.mass;
  MatrixXd local, at, content(points, block), flux(3 * points, block), into, out;
  for (Index first = 0; first < body.cells.count; first += block) {
    const Index count = std::min(block, body.cells.count - first);
    gather(body, temperature, first, count, local);
    at.noalias() = body.stacked * local;
    for (Index c = 0; c < count; ++c)
      for (Index q = 0; q < points; ++q) {
        const Index point = (first + c) * points + q;
        const double T = at(q, c);
        content(q, c) = mass[point] * body.enthalpy(T).h;
        conduct(body, point, conductivity_at(body, point, T), &at(points + 3 * q, c), &flux(3 * q, c));
      }
    into.noalias() = table.shape.transpose() * content.leftCols(count);
    out.noalias() = table.derivative.transpose() * flux.leftCols(count);
    for (Index c = 0; c < count; ++c) {
      const Index* cell = body.cells.cell(first + c);
      for (Index n = 0; n < nodes; ++n) {
        response.content[body.first_unknown + cell[n]] += into(n, c);
        response.power[body.first_unknown + cell[n]] -= out(n, c);
      }
    }
  }
}

void for_each_cell_matrix(const SolidLaws& body, const Eigen::VectorXd& temperature, double step,
                          const Eigen::VectorXd& slopes, const std::function<void(Index, CellMatrix&)>& add) {
  const core::CellTable& table = *body.cells.table;
  const Index nodes = table.nodes(), points = table.points();
  MatrixXd local, at, weighted(4 * points, nodes);
  CellMatrix matrix(nodes, nodes);
  Eigen::VectorXd capacity(points), conductance(points);
  for (Index c = 0; c < body.cells.count; ++c) {
    gather(body, temperature, c, 1, local);
    at.noalias() = table.shape * local;
    for (Index q = 0; q < points; ++q) {
      capacity[q] = (*body.mass)[c * points + q] * body.enthalpy(at(q, 0)).c;
      if (slopes.size() > 0) capacity[q] += step * slopes[c * points + q];
      conductance[q] = step * conductivity_at(body, c * points + q, at(q, 0));
    }
    for (Index n = 0; n < nodes; ++n) {
      const double* from = &body.stacked(0, n);
      double* to = &weighted(0, n);
      for (Index q = 0; q < points; ++q) to[q] = capacity[q] * from[q];
      for (Index q = 0; q < points; ++q)
        conduct(body, c * points + q, conductance[q], from + points + 3 * q, to + points + 3 * q);
    }
    matrix.noalias() = body.stacked.transpose() * weighted;
    add(c, matrix);
  }
}

void add_capacity(const SolidLaws& body, const Eigen::VectorXd& temperature, Eigen::VectorXd& capacity) {
  const core::CellTable& table = *body.cells.table;
  const Index nodes = table.nodes(), points = table.points();
  MatrixXd local, at;
  for (Index c = 0; c < body.cells.count; ++c) {
    gather(body, temperature, c, 1, local);
    at.noalias() = table.shape * local;
    for (Index q = 0; q < points; ++q) at(q, 0) = (*body.mass)[c * points + q] * body.enthalpy(at(q, 0)).c;
    local.noalias() = table.shape.transpose() * at;
    for (Index n = 0; n < nodes; ++n) capacity[body.first_unknown + body.cells.cell(c)[n]] += local(n, 0);
  }
}

}  // namespace parison::thermal
