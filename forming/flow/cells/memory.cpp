// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/cells/memory.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// Divergence of a cell's velocities at a quadrature point for 1 m/s of each, 1/m.
[[gnu::always_inline]] inline void set_divergence(const CellGeometry::AtPoint& at, int q,
                                                  std::array<VectorizedArray, cell_velocities>& divergence) {
  const auto& shape = core::cell_shapes<6>().value;
  for (int i = 0; i < 6; ++i) {
    divergence[dim * i] = at.gradient[i][0] + shape(q, i) * at.hoop;
    divergence[dim * i + 1] = at.gradient[i][1];
  }
}

}  // namespace

void leave_out_dilatation(const Problem& problem, const CellGeometry& geometry, const std::vector<double>& viscosity,
                          CellMatrices& cells) {
  for (Index batch = 0; batch < core::batch_count(problem.mesh->cell_count()); ++batch) {
    VectorizedArray* matrix = cells.batches[batch].matrix;
    for (int q = 0; q < cell_points; ++q) {
      VectorizedArray weight;
      for (int lane = 0; lane < batch_size; ++lane)
        weight[lane] = 2.0 / 3 * viscosity[geometry.cell(batch, lane) * cell_points + q];
      weight *= geometry.at(batch, q).volume;
      std::array<VectorizedArray, cell_velocities> divergence;
      set_divergence(geometry.at(batch, q), q, divergence);
      for (int i = 0; i < cell_velocities; ++i)
        for (int j = 0; j <= i; ++j) matrix[packed(i, j)] -= weight * divergence[i] * divergence[j];
    }
  }
}

Eigen::VectorXd memory_load(const Problem& problem, const CellGeometry& geometry) {
  const auto& mesh = *problem.mesh;
  const StressMemory& memory = *problem.memory;
  const auto& shape = core::cell_shapes<6>().value;
  const auto& linear = core::cell_shapes<3>().value;
  const Index velocities = dim * mesh.node_count();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(velocities + mesh.vertex_count());
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < cell_points; ++q) {
      const auto& at = geometry.at(c / batch_size, q);
      const Index lane = c % batch_size;
      const double volume = at.volume[lane], hoop = at.hoop[lane];
      const auto& [rr, zz, around, rz] = memory.stress[c * cell_points + q];
      double pressure = 0;
      for (int p = 0; p < 3; ++p) pressure += linear(q, p) * memory.pressure[mesh.cells()[c][p]];
      const double change = memory.expansion_rate[c * cell_points + q] + pressure / memory.bulk;
      for (int i = 0; i < 6; ++i) {
        const double r = at.gradient[i][0][lane], z = at.gradient[i][1][lane];
        auto force = load.segment<dim>(dim * mesh.cells()[c][i]);
        force[0] -= volume * (rr * r + rz * z + around * hoop * shape(q, i));
        force[1] -= volume * (rz * r + zz * z);
      }
      for (int p = 0; p < 3; ++p) load[velocities + mesh.cells()[c][p]] -= linear(q, p) * change * volume;
    }
  return load;
}

std::vector<PointStrain> strains(const core::Mesh& mesh, const CellGeometry& geometry,
                                 const Eigen::VectorXd& displacement) {
  const auto& shape = core::cell_shapes<6>().value;
  std::vector<PointStrain> result;
  result.reserve(mesh.cells().size() * cell_points);
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < cell_points; ++q) {
      const auto& at = geometry.at(c / batch_size, q);
      const Index lane = c % batch_size;
      double rr = 0, rz = 0, zr = 0, zz = 0, radial = 0;
      for (int i = 0; i < 6; ++i) {
        const auto u = displacement.segment<dim>(dim * mesh.cells()[c][i]);
        const double r = at.gradient[i][0][lane], z = at.gradient[i][1][lane];
        rr += u[0] * r, rz += u[0] * z, zr += u[1] * r, zz += u[1] * z;
        radial += shape(q, i) * u[0];
      }
      const double around = radial * at.hoop[lane], mean = (rr + zz + around) / 3;
      result.push_back({{rr - mean, zz - mean, around - mean, 0.5 * (rz + zr)}, 0.5 * (zr - rz)});
    }
  return result;
}

}  // namespace parison::flow
