// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/quality.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "core/element.hpp"

namespace parison::remesh {

using core::Index;

namespace {

using Derivatives = std::array<std::array<std::array<double, 2>, 6>, 6>;

const Derivatives& derivatives_at_nodes() {
  static const Derivatives table = [] {
    constexpr std::array<std::array<double, 2>, 6> nodes{{{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}};
    Derivatives d;
    for (int i = 0; i < 6; ++i) d[i] = core::triangle_shape_derivative(nodes[i][0], nodes[i][1]);
    return d;
  }();
  return table;
}

}  // namespace

double cell_quality(const core::Mesh& mesh, Index cell) {
  const double root3 = std::sqrt(3.0);
  const auto& nodes = mesh.cells[cell];
  double worst = 1;
  for (const auto& derivative : derivatives_at_nodes()) {
    core::Point da = core::Point::Zero(), db = core::Point::Zero();
    for (int i = 0; i < 6; ++i) {
      da += derivative[i][0] * mesh.nodes[nodes[i]];
      db += derivative[i][1] * mesh.nodes[nodes[i]];
    }
    // Jacobian with respect to the equilateral triangle: columns da and (2 db - da)/sqrt 3.
    core::Tensor jacobian;
    jacobian << da, (2 * db - da) / root3;
    const double norm = jacobian.squaredNorm();
    worst = std::min(worst, norm > 0 ? 2 * jacobian.determinant() / norm : 0.0);
  }
  return worst;
}

Quality quality(const core::Mesh& mesh) {
  Quality result{1, 1, 0, -1};
  std::vector<double> all(mesh.cell_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    all[cell] = cell_quality(mesh, cell);
    result.mean += all[cell] / mesh.cell_count();
    if (result.worst_cell < 0 || all[cell] < result.worst) {
      result.worst = all[cell];
      result.worst_cell = cell;
    }
  }
  if (all.empty()) return result;
  std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
  result.median = all[all.size() / 2];
  return result;
}

}  // namespace parison::remesh
