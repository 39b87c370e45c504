// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/element_matrix.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/element.hpp"

namespace parison::flow {

using core::CellPoint;
using core::dim;
using core::Tensor;

namespace {

/// Bulk viscosity in units of the shear viscosity at the same place.
constexpr double bulk_ratio = 1e10;

/// Velocity gradient and hoop rate at a quadrature point.
struct Rates {
  Tensor gradient = Tensor::Zero();
  double hoop = 0;

  double squared() const {  // D:D
    const Tensor d = 0.5 * (gradient + gradient.transpose());
    return d.squaredNorm() + hoop * hoop;
  }
};

Rates rates_at(const Problem& problem, Index cell, const CellPoint& at, const Eigen::VectorXd& velocity) {
  Rates rates;
  const double over_r = core::hoop(problem.geometry, at.position);
  for (int i = 0; i < 6; ++i) {
    const Point v = node_velocity(velocity, problem.mesh->cells[cell][i]);
    rates.gradient += v * at.gradient[i].transpose();
    rates.hoop += over_r * at.shape[i] * v[0];
  }
  return rates;
}

void add_point(double* matrix, double* load, const CellPoint& at, double over_r, double viscosity, const Point& weight) {
  const auto entry = [&](int row, int column) -> double& { return matrix[row * cell_unknowns + column]; };
  const double w = viscosity * at.volume;
  for (int i = 0; i < 6; ++i) {
    const Point& gi = at.gradient[i];
    for (int j = 0; j <= i; ++j) {
      const Point& gj = at.gradient[j];
      const double dot = w * gi.dot(gj);
      for (int a = 0; a < dim; ++a)
        for (int b = 0; b < dim; ++b) entry(dim * i + a, dim * j + b) += w * gi[b] * gj[a] + (a == b ? dot : 0.0);
      entry(dim * i, dim * j) += 2 * w * over_r * over_r * at.shape[i] * at.shape[j];
    }
    for (int q = 0; q < 3; ++q)
      for (int a = 0; a < dim; ++a)
        entry(cell_velocities + q, dim * i + a) -=
            at.volume * at.linear[q] * (gi[a] + (a == 0 ? over_r * at.shape[i] : 0.0));
    for (int a = 0; a < dim; ++a) load[dim * i + a] += at.volume * at.shape[i] * weight[a];
  }
}

}  // namespace

std::vector<double> viscosity_field(const Problem& problem, const Eigen::VectorXd& velocity) {
  const auto& mesh = *problem.mesh;
  const auto& rule = core::triangle_rule(4);
  std::vector<double> viscosity;
  viscosity.reserve(mesh.cells.size() * rule.size());
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (const auto& at : rule) {
      if (problem.viscosity) {
        viscosity.push_back(problem.viscosity(core::map_cell_point(mesh, c, problem.geometry, at).position));
        continue;
      }
      const auto shape = core::triangle_shape(at.a, at.b);
      double temperature = 0;
      for (int i = 0; i < 6; ++i) temperature += shape[i] * (*problem.temperature)[mesh.cells[c][i]];
      double value = problem.material->viscosity(temperature);
      if (problem.material->shear_thinning && velocity.size() > 0) {
        const auto& law = *problem.material->shear_thinning;
        const auto point = core::map_cell_point(mesh, c, problem.geometry, at);
        const double squared = 2 * rates_at(problem, c, point, velocity).squared();
        value *= std::pow(1 + law.time * law.time * squared, 0.5 * (law.exponent - 1));
      }
      viscosity.push_back(value);
    }
  return viscosity;
}

CellMatrices cell_matrices(const Problem& problem, const std::vector<double>& viscosity) {
  const auto& mesh = *problem.mesh;
  const auto& rule = core::triangle_rule(4);
  CellMatrices cells;
  cells.matrix.assign(mesh.cells.size() * cell_unknowns * cell_unknowns, 0.0);
  cells.load.assign(mesh.cells.size() * cell_unknowns, 0.0);
  const Point weight = problem.material->density * problem.gravity * problem.body_force_direction;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    double* matrix = cells.matrix.data() + std::size_t(c) * cell_unknowns * cell_unknowns;
    double* load = cells.load.data() + std::size_t(c) * cell_unknowns;
    for (std::size_t q = 0; q < rule.size(); ++q) {
      const auto at = core::map_cell_point(mesh, c, problem.geometry, rule[q]);
      const Point force = problem.force ? Point(weight + problem.force(at.position)) : weight;
      add_point(matrix, load, at, core::hoop(problem.geometry, at.position), viscosity[c * rule.size() + q], force);
      const double compliance = 1 / (bulk_ratio * viscosity[c * rule.size() + q]);
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j <= i; ++j)
          matrix[(cell_velocities + i) * cell_unknowns + cell_velocities + j] -=
              compliance * at.volume * at.linear[i] * at.linear[j];
      for (int i = 0; i < 3; ++i) load[cell_velocities + i] -= problem.volume_rate * at.volume * at.linear[i];
    }
    for (int i = 0; i < cell_unknowns; ++i)
      for (int j = i + 1; j < cell_unknowns; ++j) matrix[i * cell_unknowns + j] = matrix[j * cell_unknowns + i];
  }
  return cells;
}

Eigen::VectorXd surface_load(const Problem& problem, const std::vector<bool>& exposed) {
  const auto& mesh = *problem.mesh;
  Eigen::VectorXd load = Eigen::VectorXd::Zero(dim * mesh.node_count());
  for (std::size_t e = 0; e < mesh.boundary.size(); ++e) {
    const auto& edge = mesh.boundary[e];
    const auto& condition = problem.pieces[edge.piece];
    if (condition.kind != PieceCondition::Kind::free || !exposed[e]) continue;
    for (const auto& rule : core::edge_rule(3)) {
      const auto at = core::map_edge_point(mesh, edge.nodes, problem.geometry, rule);
      const auto slope = core::edge_shape_derivative(rule.s);
      Point along = Point::Zero();
      for (int i = 0; i < 3; ++i) along += slope[i] * mesh.nodes[edge.nodes[i]];
      const double tension = problem.material->surface_tension * at.area;
      for (int i = 0; i < 3; ++i) {
        auto nodal = load.segment<dim>(dim * edge.nodes[i]);
        nodal -= condition.pressure * at.area * at.shape[i] * at.normal;
        nodal -= tension * slope[i] / along.norm() * at.tangent;
        nodal[0] -= tension * core::hoop(problem.geometry, at.position) * at.shape[i];
      }
    }
  }
  return load;
}

Eigen::VectorXd contact_areas(const core::Mesh& mesh, core::Geometry geometry, const std::vector<bool>& pressed) {
  Eigen::VectorXd area = Eigen::VectorXd::Zero(mesh.node_count()), any = area;
  for (const auto& edge : mesh.boundary) {
    const bool closed = pressed[edge.nodes[0]] && pressed[edge.nodes[1]] && pressed[edge.nodes[2]];
    for (const auto& rule : core::edge_rule(3)) {
      const auto at = core::map_edge_point(mesh, edge.nodes, geometry, rule);
      for (int i = 0; i < 3; ++i) (closed ? area : any)[edge.nodes[i]] += at.area * at.shape[i];
    }
  }
  for (Index n = 0; n < mesh.node_count(); ++n)
    if (pressed[n] && area[n] <= 0) area[n] = std::max(area[n], any[n]);
  return area;
}

void evaluate_dissipation(const Problem& problem, const std::vector<double>& viscosity, Solution& solution) {
  const auto& rule = core::triangle_rule(4);
  solution.dissipation.clear();
  solution.dissipation.reserve(viscosity.size());
  std::vector<std::pair<double, double>> squared_and_volume;
  double total = 0, sum = 0;
  for (Index c = 0; c < problem.mesh->cell_count(); ++c)
    for (const auto& q : rule) {
      const auto at = core::map_cell_point(*problem.mesh, c, problem.geometry, q);
      const double squared = rates_at(problem, c, at, solution.velocity).squared();
      squared_and_volume.push_back({squared, at.volume});
      total += at.volume;
      sum += 2 * squared * at.volume;
      solution.dissipation.push_back(2 * viscosity[solution.dissipation.size()] * squared * at.volume);
    }
  solution.mean_rate = std::sqrt(sum / total);
  std::sort(squared_and_volume.rbegin(), squared_and_volume.rend());
  double above = 0;
  for (const auto& [squared, volume] : squared_and_volume) {
    solution.high_rate = std::sqrt(2 * squared);
    above += volume;
    if (above > high_rate_share * total) break;
  }
}

}  // namespace parison::flow
