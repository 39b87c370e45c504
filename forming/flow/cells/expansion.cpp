// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/expansion.hpp"

#include "forming/flow/contact/grip.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// Divergence of velocity component `a` of node i at a quadrature point, for 1 m/s there, 1/m.
double divergence_of(const CellGeometry::AtPoint& at, Index lane, int q, int i, int a) {
  const double along = at.gradient[i][a][lane];
  return a == 0 ? along + core::cell_shapes<6>().value(q, i) * at.hoop[lane] : along;
}

}  // namespace

Eigen::VectorXd expansion_load(const Problem& problem, const CellGeometry& geometry,
                               const std::vector<double>& viscosity) {
  const auto& mesh = *problem.mesh;
  const auto& linear = core::cell_shapes<3>().value;
  const Index velocities = dim * mesh.node_count();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(velocities + mesh.vertex_count());
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < cell_points; ++q) {
      const auto& at = geometry.at(c / batch_size, q);
      const Index lane = c % batch_size, point = c * cell_points + q;
      const double change = problem.expansion_rate[point] * at.volume[lane];
      const double stress = 2.0 / 3 * viscosity[point] * change;
      for (int i = 0; i < 6; ++i)
        for (int a = 0; a < dim; ++a) load[dim * mesh.cells()[c][i] + a] += stress * divergence_of(at, lane, q, i, a);
      for (int p = 0; p < 3; ++p) load[velocities + mesh.cells()[c][p]] -= linear(q, p) * change;
    }
  leave_out_gripped(problem, load);
  return load;
}

double divergence(const core::Mesh& mesh, const CellGeometry& geometry, Index cell, int q,
                  const Eigen::VectorXd& velocity) {
  const auto& at = geometry.at(cell / batch_size, q);
  double sum = 0;
  for (int i = 0; i < 6; ++i)
    for (int a = 0; a < dim; ++a)
      sum += divergence_of(at, cell % batch_size, q, i, a) * velocity[dim * mesh.cells()[cell][i] + a];
  return sum;
}

double leave_out_expansion(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                           const Eigen::VectorXd& velocity, double dilatation_rate, Dissipation& dissipation) {
  double missing = 0;
  for (Index c = 0; c < geometry.cells; ++c)
    for (int q = 0; q < cell_points; ++q) {
      const Index point = c * cell_points + q;
      const double rate = divergence(*problem.mesh, geometry, c, q, velocity);
      const double expansion = problem.expansion_rate[point];
      const double share =
          2.0 / 3 * viscosity[point] * expansion * geometry.at(c / batch_size, q).volume[c % batch_size];
      dissipation.power[point] += share * (expansion - 2 * rate);
      missing += share * (rate - 0.5 * dilatation_rate - expansion);
    }
  return missing;
}

}  // namespace parison::flow
