// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/contact/grip.hpp"

#include <algorithm>
#include <vector>

#include "forming/flow/contact/wedged_corner.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// Places at which the glass may touch two tools that move against each other.
std::vector<Point> wedges(const Problem& problem) {
  std::vector<Point> places;
  for (std::size_t i = 1; i < problem.candidates.size(); ++i) {
    const ContactCandidate &a = problem.candidates[i - 1], &b = problem.candidates[i];
    const ToolMotion &first = problem.tools[a.tool], &second = problem.tools[b.tool];
    const bool together = a.tool == b.tool || (!first.force && !second.force && first.velocity == second.velocity);
    if (a.node == b.node && !together) places.push_back(problem.mesh->nodes[a.node]);
  }
  return places;
}

}  // namespace

bool held_by_form(const Problem& problem, const ContactCandidate& candidate) {
  const ToolMotion& tool = problem.tools[candidate.tool];
  return candidate.tied && tool.friction.law == Friction::Law::grip && !tool.force;
}

Eigen::VectorXd grip_resistance(const Problem& problem, const std::vector<SurfaceEdge>& surface) {
  const core::Mesh& mesh = *problem.mesh;
  std::vector<bool> held(mesh.nodes.size(), false);
  const double beside = give_way_share * core::size(mesh);
  const std::vector<Point> corners = wedges(problem);
  for (const ContactCandidate& candidate : problem.candidates)
    held[candidate.node] = held[candidate.node] || (held_by_form(problem, candidate) &&
                                                    std::none_of(corners.begin(), corners.end(), [&](const Point& x) {
                                                      return (x - mesh.nodes[candidate.node]).norm() < beside;
                                                    }));
  if (std::find(held.begin(), held.end(), true) == held.end()) return {};
  const Eigen::VectorXd area = contact_areas(mesh, surface, held);
  Eigen::VectorXd resistance = Eigen::VectorXd::Zero(mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n)
    if (held[n]) resistance[n] = grip_drag * area[n];
  return resistance;
}

void add_grips(const core::Mesh& mesh, const Eigen::VectorXd& resistance, CellMatrices& cells) {
  Eigen::VectorXd left = resistance;
  for (Index c = 0; left.size() > 0 && c < mesh.cell_count(); ++c)
    for (int i = 0; i < 6; ++i) {
      double& here = left[mesh.cells()[c][i]];
      for (int a = 0; here > 0 && a < dim; ++a)
        cells.batches[c / batch_size].matrix[packed(dim * i + a, dim * i + a)][c % batch_size] += here;
      here = 0;
    }
}

Eigen::VectorXd grip_load(const Problem& problem, const Eigen::VectorXd& resistance) {
  Eigen::VectorXd load = Eigen::VectorXd::Zero(dim * problem.mesh->node_count());
  if (resistance.size() == 0) return load;
  for (const ContactCandidate& candidate : problem.candidates)
    if (held_by_form(problem, candidate))
      load.segment<dim>(dim * candidate.node) =
          resistance[candidate.node] * problem.tools[candidate.tool].velocity * core::axis_direction();
  return load;
}

}  // namespace parison::flow
