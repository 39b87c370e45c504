// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/contact/wedged_corner.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace parison::flow {

using core::dim;

namespace {

/// Whether a tool that moves against another one pushes the glass of their common corner along that, so that it slides
/// there by more than a small share of their relative speed.
bool wedges(const Problem& problem, const NodeEquality& other, const NodeEquality& along) {
  constexpr double small = 1e-3;
  const ToolMotion &a = problem.tools[along.tool], &b = problem.tools[other.tool];
  if (!a.force && !b.force && a.velocity == b.velocity) return false;
  return std::abs(other.normal.dot(core::axis_direction())) >
         small * std::abs(other.normal.dot(perpendicular(along.normal)));
}

}  // namespace

void add_wedged_corners(const Problem& problem, Index node, const NodeEqualities& equalities,
                        std::vector<WedgedCorner>& corners) {
  if (equalities.size() != dim) return;
  const NodeEquality &a = equalities[0], &b = equalities[1];
  if (a.candidate < 0 || b.candidate < 0 || a.tool == b.tool) return;
  for (const auto& [along, other] : {std::pair(a, b), std::pair(b, a)})
    if (sticks(problem, problem.candidates[along.candidate]) && wedges(problem, other, along))
      corners.push_back({problem.mesh->nodes[node], along.tool, give_way_share * core::size(*problem.mesh)});
}

double give_way(const Problem& problem, Index node, Index tool, const std::vector<WedgedCorner>& corners) {
  double nearest = 1, length = 0;
  for (const WedgedCorner& corner : corners)
    if (corner.tool == tool)
      if (const double share = (problem.mesh->nodes[node] - corner.at).norm() / corner.length; share < nearest) {
        nearest = share;
        length = corner.length;
      }
  return nearest < 1 ? nearest / (1 - nearest) / length : std::numeric_limits<double>::infinity();
}

double viscosity_at(const Problem& problem, Index node) {
  return problem.viscosity ? problem.viscosity(problem.mesh->nodes[node])
                           : problem.material->viscosity((*problem.temperature)[node]);
}

}  // namespace parison::flow
