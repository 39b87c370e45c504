// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/discretisation.hpp"

#include "core/mesh/element.hpp"
#include "forming/flow/cells/expansion.hpp"
#include "forming/flow/cells/memory.hpp"
#include "forming/flow/contact/grip.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// Right-hand side of div v = 1/s. Glass that a tool grips cannot dilate: its vertices are left out.
Eigen::VectorXd dilatation_load(const Problem& problem, const CellGeometry& geometry) {
  const auto& mesh = *problem.mesh;
  const auto& rule = core::triangle_rule(4);
  const Index velocities = dim * mesh.node_count();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(velocities + mesh.vertex_count());
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < cell_points; ++q) {
      const double linear[3] = {1 - rule[q].a - rule[q].b, rule[q].a, rule[q].b};
      const double volume = geometry.at(c / batch_size, q).volume[c % batch_size];
      for (int p = 0; p < 3; ++p) load[velocities + mesh.cells()[c][p]] -= linear[p] * volume;
    }
  leave_out_gripped(problem, load);
  return load;
}

}  // namespace

void update_viscosity(const Problem& problem, const Eigen::VectorXd& velocity, Discretisation& discretisation) {
  discretisation.viscosity = viscosity_field(problem, discretisation.geometry, velocity);
  discretisation.cells = cell_matrices(problem, discretisation.geometry, discretisation.viscosity);
  add_grips(*problem.mesh, discretisation.grip_resistance, discretisation.cells);
  if (!problem.expansion_rate.empty())
    discretisation.expansion_load = expansion_load(problem, discretisation.geometry, discretisation.viscosity);
  if (problem.memory) discretisation.expansion_load = memory_load(problem, discretisation.geometry);
}

Discretisation discretise(const Problem& problem) {
  const auto& mesh = *problem.mesh;
  Discretisation result{cell_geometry(mesh, problem.geometry), surface_edges(problem), {}, {}, {}, {}, {}, {}, {}};
  result.grip_resistance = grip_resistance(problem, result.surface);
  update_viscosity(problem, {}, result);
  if (problem.material->shear_thinning) result.shear_thinning_jacobian = result.cells;
  result.dilatation_load = dilatation_load(problem, result.geometry);
  result.load = cell_loads(mesh, result.cells) + problem.dilatation_rate * result.dilatation_load;
  result.load.head(dim * mesh.node_count()) += grip_load(problem, result.grip_resistance);
  return result;
}

}  // namespace parison::flow
