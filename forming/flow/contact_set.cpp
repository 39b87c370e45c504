// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/contact_set.hpp"

#include <algorithm>

namespace parison::flow {

using core::dim;

namespace {

/// Slower than this into a tool is round-off to a run of seconds, m/s.
constexpr double standstill = 1e-8;
/// A contact released this often in one solve stays closed: the set would cycle.
constexpr int most_releases = 3;

}  // namespace

std::vector<bool> first_set(const Problem& problem, const std::vector<bool>& warm) {
  std::vector<bool> active(problem.candidates.size(), false);
  for (std::size_t i = 0; i < active.size(); ++i)
    active[i] = problem.candidates[i].held || (warm.empty() ? problem.candidates[i].rate >= 0 : bool(warm[i]));
  return active;
}

SetChange update_set(const Problem& problem, const Instant& instant, std::vector<bool>& active, std::vector<int>& releases) {
  const Eigen::VectorXd pressed = shared_forces(problem, active, instant.forces.normal);
  const double force_noise = 1e-6 * instant.forces.normal.lpNorm<Eigen::Infinity>();
  const double speed_noise =
      1e-9 * instant.unknowns.head(dim * problem.mesh->node_count()).lpNorm<Eigen::Infinity>() + standstill;
  const Point axis = core::axis_direction();
  SetChange change;
  for (std::size_t i = 0; i < active.size(); ++i) {
    const auto& candidate = problem.candidates[i];
    if (active[i]) {
      if (candidate.held) continue;
      // A vertex carries its neighbours' share: its own quadratic weight may vanish or oscillate.
      const double force = candidate.node < problem.mesh->vertex_count && instant.forces.normal[i] < 0
                               ? pressed[candidate.node]
                               : instant.forces.normal[i];
      if (force >= -force_noise) continue;
      if (releases[i] >= most_releases) {
        ++change.latched;
        continue;
      }
      active[i] = false;
      ++releases[i];
      ++change.changed;
    } else {
      const Point relative = node_velocity(instant.unknowns, candidate.node) - instant.tool_velocity[candidate.tool] * axis;
      if (candidate.normal.dot(relative) >= candidate.rate - speed_noise) continue;
      active[i] = true;
      ++change.changed;
    }
  }
  return change;
}

Eigen::VectorXd friction_drag(const Problem& problem, const std::vector<bool>& active, const Eigen::VectorXd& area,
                              const Instant* last) {
  Eigen::VectorXd drag = Eigen::VectorXd::Zero(area.size());
  for (std::size_t i = 0; i < active.size(); ++i) {
    if (!active[i]) continue;
    const auto& candidate = problem.candidates[i];
    const auto& friction = problem.tools[candidate.tool].friction;
    drag[candidate.node] = candidate.share * friction.coefficient * area[candidate.node];
    if (!friction.coulomb || !last) continue;
    Point slip = node_velocity(last->unknowns, candidate.node) - last->tool_velocity[candidate.tool] * core::axis_direction();
    slip -= slip.dot(candidate.normal) * candidate.normal;
    const double cap = *friction.coulomb * std::max(0.0, last->forces.normal[i]);
    if (drag[candidate.node] * slip.norm() > cap) drag[candidate.node] = cap / slip.norm();
  }
  return drag;
}

}  // namespace parison::flow
