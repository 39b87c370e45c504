// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/balance.hpp"

#include <algorithm>
#include <cmath>

namespace parison::flow {

using core::dim;

std::vector<Index> held_batches(const core::Mesh& mesh, const Held& held) {
  std::vector<Index> batches;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto& nodes = mesh.cells[c];
    if (!batches.empty() && batches.back() == c / lanes) continue;
    if (std::any_of(nodes.begin(), nodes.end(), [&](Index node) { return held.find(node); })) batches.push_back(c / lanes);
  }
  return batches;
}

Eigen::VectorXd unbalanced(const Problem& problem, const Held& held, const Eigen::VectorXd& load, const Iterate& iterate) {
  Eigen::VectorXd residual = load - iterate.force;
  const auto tools = driven_tools(problem);
  for (const auto& frame : held.frames) {
    if (frame.friction_tool < 0) continue;
    const Point along = frame.frame.col(dim - 1);
    const auto k = std::find(tools.begin(), tools.end(), frame.friction_tool);
    const double wall =
        k == tools.end() ? problem.tools[frame.friction_tool].velocity : iterate.driven[k - tools.begin()];
    const double slip = along.dot(node_velocity(iterate.x, frame.node) - wall * core::axis_direction());
    residual.segment<dim>(dim * frame.node) -= (held.drag[frame.node] * slip + held.pull[frame.node]) * along;
  }
  return residual;
}

double imbalance(const Problem& problem, const CellMatrices& cells, const Held& held, const Eigen::VectorXd& load,
                 Iterate& iterate) {
  const Eigen::MatrixXd parts = product_and_size(*problem.mesh, cells, iterate.x);
  iterate.force = parts.col(0);
  const Eigen::VectorXd size = parts.col(1) + load.cwiseAbs();
  Eigen::VectorXd residual = unbalanced(problem, held, load, iterate);
  for (const auto& frame : held.frames)
    for (int a = 0; a < dim; ++a)
      if (frame.fixed[a]) {
        auto there = residual.segment<dim>(dim * frame.node);
        there -= (frame.frame.col(a).dot(there) * frame.frame.col(a)).eval();
      }
  double worst = 0;
  for (Index i = 0; i < residual.size(); ++i)
    if (residual[i] != 0) worst = std::max(worst, std::abs(residual[i]) / size[i]);
  return worst;
}

}  // namespace parison::flow
