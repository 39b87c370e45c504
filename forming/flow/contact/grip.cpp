// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/contact/grip.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "forming/flow/contact/wedged_corner.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// The corners in which the glass may touch two tools that move against each other, along both.
std::vector<WedgedCorner> possible_wedges(const Problem& problem) {
  std::vector<WedgedCorner> corners;
  const double length = give_way_share * core::size(*problem.mesh);
  for (std::size_t i = 1; i < problem.candidates.size(); ++i) {
    const ContactCandidate &a = problem.candidates[i - 1], &b = problem.candidates[i];
    const ToolMotion &first = problem.tools[a.tool], &second = problem.tools[b.tool];
    const bool together = a.tool == b.tool || (!first.force && !second.force && first.velocity == second.velocity);
    if (a.node != b.node || together) continue;
    for (const Index tool : {a.tool, b.tool}) corners.push_back({problem.mesh->nodes[a.node], tool, length});
  }
  return corners;
}

}  // namespace

bool held_by_form(const Problem& problem, const ContactCandidate& candidate) {
  const ToolMotion& tool = problem.tools[candidate.tool];
  return candidate.tied && tool.friction.law == Friction::Law::grip && !tool.force;
}

void leave_out_gripped(const Problem& problem, Eigen::VectorXd& load) {
  const core::Mesh& mesh = *problem.mesh;
  for (const ContactCandidate& candidate : problem.candidates)
    if (candidate.tied && !held_by_form(problem, candidate) && candidate.node < mesh.vertex_count())
      load[dim * mesh.node_count() + candidate.node] = 0;
}

Eigen::VectorXd grip_resistance(const Problem& problem, const std::vector<SurfaceEdge>& surface) {
  const core::Mesh& mesh = *problem.mesh;
  std::vector<bool> held(mesh.nodes.size(), false);
  Eigen::VectorXd drag = Eigen::VectorXd::Zero(mesh.node_count());
  const std::vector<WedgedCorner> corners = possible_wedges(problem);
  for (const ContactCandidate& candidate : problem.candidates) {
    if (!held_by_form(problem, candidate)) continue;
    const Index node = candidate.node;
    const double give = give_way(problem, node, candidate.tool, corners);
    const double here = std::isinf(give) ? grip_drag : std::min(grip_drag, give * viscosity_at(problem, node));
    drag[node] = std::max(drag[node], here);
    held[node] = true;
  }
  if (std::find(held.begin(), held.end(), true) == held.end()) return {};
  return drag.cwiseProduct(contact_areas(mesh, surface, held));
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
