// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/contact/active_set.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mesh/tolerances.hpp"
#include "forming/flow/contact/grip.hpp"
#include "forming/flow/contact/wedged_corner.hpp"

namespace parison::flow {

using core::dim;

namespace {

/// A contact opened this often in one solve is locked in the active set, which would cycle otherwise.
constexpr int max_releases = 3;
/// Contacts open whose tension is at least this share of the largest. In a step in which a tumbler loses its plunger,
/// shares from 0.03 to 0.3 gave the same contacts; the larger, the more iterations.
constexpr double opening_share = 0.1;
/// A node whose slip changed its sign this often takes the secant of the friction law.
constexpr int max_reversals = 3;
/// Tangential stiffness at Coulomb's limit relative to that of the secant. The tangent itself is zero and would make
/// the matrix singular where all contacts slide.
constexpr double min_stiffness_ratio = 1e-3;

/// Viscous force of speeds that count as round-off, N: glass that nothing loads has such contact forces of either sign.
double round_off_force(const Problem& problem) {
  const double size = core::size(*problem.mesh), speed = core::tolerance::round_off_speed * size;
  const double hottest = problem.temperature && problem.temperature->size() > 0 ? problem.temperature->maxCoeff() : 0;
  return problem.material->viscosity(hottest) * speed * size;
}

/// Whether a candidate is active whatever pulls on it.
bool stays_active(const Problem& problem, const ContactCandidate& candidate) {
  return candidate.tied && !held_by_form(problem, candidate);
}

/// Tension of each active contact that may open, Pa; 0 of all others, and where it is round-off.
Eigen::VectorXd contact_tension(const Problem& problem, const Response& response, const Eigen::VectorXd& area,
                                const std::vector<bool>& active) {
  const Eigen::VectorXd& force = response.forces.normal;
  const Eigen::VectorXd shared_force = lumped_forces(problem, active, force),
                        shared_area = distribute_mid_sides(*problem.mesh, area);
  const double noise = 1e-6 * force.lpNorm<Eigen::Infinity>() + round_off_force(problem);
  Eigen::VectorXd tension = Eigen::VectorXd::Zero(force.size());
  for (Index i = 0; i < tension.size(); ++i) {
    const auto& candidate = problem.candidates[i];
    if (!active[i] || force[i] >= 0 || stays_active(problem, candidate)) continue;
    // A vertex is in tension where its lumped force is too: the consistent force of a quadratic shape function may
    // oscillate there.
    const bool vertex = candidate.node < problem.mesh->vertex_count();
    const double pull = -(vertex ? shared_force[candidate.node] : force[i]),
                 over = (vertex ? shared_area : area)[candidate.node];
    if (pull > noise) tension[i] = over > 0 ? pull / over : std::numeric_limits<double>::max();
  }
  return tension;
}

}  // namespace

std::vector<bool> initial_active_set(const Problem& problem, const std::vector<bool>& guess) {
  std::vector<bool> active(problem.candidates.size(), false);
  for (std::size_t i = 0; i < active.size(); ++i)
    active[i] = stays_active(problem, problem.candidates[i]) ||
                (guess.empty() ? problem.candidates[i].rate >= 0 : bool(guess[i]));
  return active;
}

ActiveSetChange update_active_set(const Problem& problem, const Response& response, const Eigen::VectorXd& area,
                                  std::vector<bool>& active, std::vector<int>& releases) {
  const Eigen::VectorXd tension = contact_tension(problem, response, area, active);
  double largest = 0;
  for (std::size_t i = 0; i < active.size(); ++i)
    if (releases[i] < max_releases) largest = std::max(largest, tension[Index(i)]);
  const double speed_noise = 1e-9 * response.unknowns.head(dim * problem.mesh->node_count()).lpNorm<Eigen::Infinity>() +
                             core::tolerance::round_off_speed * core::size(*problem.mesh);
  const Point axis = core::axis_direction();
  ActiveSetChange change;
  for (std::size_t i = 0; i < active.size(); ++i) {
    const auto& candidate = problem.candidates[i];
    if (active[i]) {
      if (tension[Index(i)] <= 0) continue;
      if (releases[i] >= max_releases) {
        ++change.locked;
        continue;
      }
      if (tension[Index(i)] < opening_share * largest) continue;
      active[i] = false;
      ++releases[i];
      ++change.changed;
    } else {
      const Point relative =
          node_velocity(response.unknowns, candidate.node) - response.tool_velocity[candidate.tool] * axis;
      if (candidate.normal.dot(relative) >= candidate.rate - speed_noise) continue;
      active[i] = true;
      ++change.changed;
    }
  }
  return change;
}

namespace {

/// Shear stress over slip at a node that a tool holds by friction, Pa.s/m.
double drag(const Problem& problem, const NodeConstraint& constraint) {
  const Index node = constraint.node;
  if (constraint.give > 0) return constraint.give * viscosity_at(problem, node);
  const Friction& friction = problem.tools[constraint.friction_tool].friction;
  return friction.by_temperature ? friction.coefficient_at((*problem.temperature)[node]) : friction.coefficient;
}

}  // namespace

void add_friction(const Problem& problem, const std::vector<bool>& active, const Eigen::VectorXd& area,
                  const Response* last, CoulombSliding& sliding, Constraints& constraints) {
  ++sliding.iterations;
  for (const auto& constraint : constraints.nodes) {
    if (constraint.friction_tool < 0) continue;
    const Index node = constraint.node, i = constraint.equalities[0].candidate;
    const auto& friction = problem.tools[constraint.friction_tool].friction;
    const double navier = problem.candidates[i].contact_fraction * drag(problem, constraint) * area[node];
    constraints.tangential_stiffness[node] = navier;
    if (!friction.coulomb || !last || !active[i]) continue;
    const Point relative =
        node_velocity(last->unknowns, node) - last->tool_velocity[constraint.friction_tool] * core::axis_direction();
    const double slip = constraint.basis.col(dim - 1).dot(relative),
                 cap = sliding.cap_of(i, *friction.coulomb * std::max(0.0, last->forces.normal[i]));
    const int sense = navier * std::abs(slip) <= cap ? 0
                      : slip > 0                     ? 1
                                                     : -1,
              before = std::exchange(sliding.sense[i], sense);
    if (sense == 0) continue;
    if (sense == -before) {
      sliding.sense[i] = 0;
      if (sliding.reversals[i]++ < max_reversals) continue;
    }
    const double secant = cap / std::abs(slip);
    constraints.tangential_stiffness[node] =
        sliding.reversals[i] < max_reversals ? min_stiffness_ratio * secant : secant;
    constraints.tangential_load[node] = sense * cap - constraints.tangential_stiffness[node] * slip;
  }
}

}  // namespace parison::flow
