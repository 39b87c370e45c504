// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/solver.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "forming/flow/contact_forces.hpp"
#include "forming/flow/correction.hpp"
#include "forming/flow/support.hpp"

namespace parison::flow {

using core::dim;

namespace {

constexpr int most_iterations = 200;
/// Of a force, or a volume flow, against the cells' parts that make it up.
constexpr double balanced = 1e-10;
/// Where viscosity or friction depend on the flow, the change of the velocities at which they are found, relative.
constexpr double same_flow = 1e-6;
/// Slower than this into a tool is round-off to a run of seconds, m/s.
constexpr double standstill = 1e-8;
/// A contact released this often in one solve stays closed: the set would cycle.
constexpr int most_releases = 3;
/// Share of the largest resistance by which tools that press glass against each other alone are kept from drifting.
constexpr double least_resistance = 1e-12;

/// The candidates that start closed: the guess, or those without a gap.
std::vector<bool> first_set(const Problem& problem, const std::vector<bool>& warm) {
  std::vector<bool> active(problem.candidates.size(), false);
  for (std::size_t i = 0; i < active.size(); ++i)
    active[i] = problem.candidates[i].held || (warm.empty() ? problem.candidates[i].rate >= 0 : bool(warm[i]));
  return active;
}

/// Edges not wholly pressed against tools: gas pressure and surface tension act there.
std::vector<bool> exposed_edges(const core::Mesh& mesh, const std::vector<bool>& pressed) {
  std::vector<bool> exposed;
  for (const auto& edge : mesh.boundary)
    exposed.push_back(!(pressed[edge.nodes[0]] && pressed[edge.nodes[1]] && pressed[edge.nodes[2]]));
  return exposed;
}

}  // namespace

struct Solver::Data : Corrector {
  using Corrector::Corrector;
};

namespace {

/// Velocities of the driven tools: force balance, or the speed limit where it would be passed.
/// `force` column 0 is the axial force at rest, column 1 + k its growth per m/s of driven tool k.
Eigen::VectorXd drive(const Problem& problem, const std::vector<Index>& driven, const Eigen::MatrixXd& force) {
  const auto count = static_cast<Index>(driven.size());
  Eigen::VectorXd velocity = Eigen::VectorXd::Zero(count);
  if (count == 0) return velocity;
  std::vector<bool> limited(count, false);
  for (Index round = 0; round <= count; ++round) {
    Eigen::MatrixXd resistance = Eigen::MatrixXd::Identity(count, count);
    Eigen::VectorXd rhs = velocity;
    for (Index k = 0; k < count; ++k) {
      if (limited[k]) continue;
      resistance.row(k) = force.block(k, 1, 1, count);
      rhs[k] = *problem.tools[driven[k]].force - force(k, 0);
    }
    for (Index k = 0; k < count; ++k)
      if (!limited[k] && resistance(k, k) <= 0) {  // nothing resists
        limited[k] = true;
        velocity[k] = std::copysign(problem.tools[driven[k]].speed_limit, rhs[k]);
        resistance.row(k) = Eigen::RowVectorXd::Unit(count, k);
        rhs[k] = velocity[k];
      }
    const double least = least_resistance * resistance.diagonal().maxCoeff();
    for (Index k = 0; k < count; ++k)
      if (!limited[k]) resistance(k, k) += least;
    velocity = resistance.partialPivLu().solve(rhs);
    Index furthest = -1;  // over its limit, of those not yet held by it
    double most = 1;
    for (Index k = 0; k < count; ++k)
      if (const double share = std::abs(velocity[k]) / problem.tools[driven[k]].speed_limit; !limited[k] && share > most) {
        most = share;
        furthest = k;
      }
    if (furthest < 0) break;
    velocity[furthest] = std::copysign(problem.tools[driven[furthest]].speed_limit, velocity[furthest]);
    limited[furthest] = true;
  }
  return velocity;
}

/// One iteration's outcome, all tools' velocities known.
struct Instant {
  Eigen::VectorXd unknowns;
  ContactForces forces;
  std::vector<double> tool_velocity;
};

Instant combine(const Problem& problem, const std::vector<NodeFrame>& frames, const Eigen::MatrixXd& solution,
                const Eigen::MatrixXd& reaction) {
  const auto driven = driven_tools(problem);
  const auto columns = solution.cols();
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(Index(driven.size()), columns);
  std::vector<ContactForces> parts;
  for (Index column = 0; column < columns; ++column) {
    parts.push_back(contact_forces(problem, frames, reaction.col(column)));
    for (std::size_t i = 0; i < problem.candidates.size(); ++i)
      for (std::size_t k = 0; k < driven.size(); ++k)
        if (problem.candidates[i].tool == driven[k]) force(k, column) += parts.back().axial[i];
  }
  const Eigen::VectorXd velocity = drive(problem, driven, force);
  Instant instant{solution.col(0), parts[0], {}};
  for (const auto& tool : problem.tools) instant.tool_velocity.push_back(tool.velocity);
  for (std::size_t k = 0; k < driven.size(); ++k) {
    instant.unknowns += velocity[k] * solution.col(1 + k);
    instant.forces.normal += velocity[k] * parts[1 + k].normal;
    instant.forces.axial += velocity[k] * parts[1 + k].axial;
    instant.tool_velocity[driven[k]] = velocity[k];
  }
  return instant;
}

/// Closes the contacts that would be passed through and opens those that pull; true when the set changed.
bool update_set(const Problem& problem, const Instant& instant, std::vector<bool>& active, std::vector<int>& releases) {
  const Eigen::VectorXd pressed = shared_forces(problem, active, instant.forces.normal);
  const double force_noise = 1e-6 * instant.forces.normal.lpNorm<Eigen::Infinity>();
  const double speed_noise =
      1e-9 * instant.unknowns.head(dim * problem.mesh->node_count()).lpNorm<Eigen::Infinity>() + standstill;
  const Point axis = core::axis_direction();
  bool changed = false;
  for (std::size_t i = 0; i < active.size(); ++i) {
    const auto& candidate = problem.candidates[i];
    if (active[i]) {
      if (candidate.held || releases[i] >= most_releases) continue;
      // A vertex carries its neighbours' share: its own quadratic weight may vanish or oscillate.
      const double force = candidate.node < problem.mesh->vertex_count && instant.forces.normal[i] < 0
                               ? pressed[candidate.node]
                               : instant.forces.normal[i];
      if (force >= -force_noise) continue;
      active[i] = false;
      ++releases[i];
      changed = true;
    } else {
      const Point relative = node_velocity(instant.unknowns, candidate.node) - instant.tool_velocity[candidate.tool] * axis;
      if (candidate.normal.dot(relative) >= candidate.rate - speed_noise) continue;
      active[i] = true;
      changed = true;
    }
  }
  return changed;
}

/// Gravity, gas pressure, surface tension and the wanted change of volume, on every unknown.
Eigen::VectorXd whole_load(const Problem& problem, const CellMatrices& cells, const std::vector<bool>& exposed) {
  const auto& mesh = *problem.mesh;
  const Index velocities = dim * mesh.node_count();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(velocities + mesh.vertex_count);
  load.head(velocities) = surface_load(problem, exposed);
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    const auto where = unknowns_of(mesh, c);
    for (int i = 0; i < cell_unknowns; ++i) load[where[i]] += cells.load[std::size_t(c) * cell_unknowns + i];
  }
  // Held glass cannot take part in a change of volume.
  for (const auto& candidate : problem.candidates)
    if (candidate.held && candidate.node < mesh.vertex_count) load[velocities + candidate.node] = 0;
  return load;
}

/// Navier drag per node, N.s/m, capped by Coulomb's limit at the last iterate.
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

}  // namespace

Solver::Solver(const core::Mesh& mesh) : data_(std::make_unique<Data>(mesh)) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

Solution Solver::solve(const Problem& problem, const std::vector<bool>& warm) {
  auto& corrector = *data_;
  const auto& mesh = *problem.mesh;
  const Index velocities = dim * mesh.node_count(), size = velocities + mesh.vertex_count;
  const auto driven = driven_tools(problem);
  Solution result;
  result.reason = free_motion(problem);
  if (!result.reason.empty()) return result;
  result.active = first_set(problem, warm);
  std::vector<int> releases(result.active.size(), 0);
  auto viscosity = viscosity_field(problem, {});
  auto cells = cell_matrices(problem, viscosity);
  corrector.forget();
  corrector.factorisations = 0;
  Iterate iterate{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(Index(driven.size()))};
  const bool linear = !problem.material->shear_thinning &&
                      std::none_of(problem.tools.begin(), problem.tools.end(),
                                   [](const ToolMotion& tool) { return tool.friction.coulomb.has_value(); });
  std::optional<Instant> instant;
  Eigen::VectorXd area;
  for (bool settled = false, refined = false; !settled;) {
    if (result.iterations++ == most_iterations) {
      result.reason = "the contact set did not settle";
      return result;
    }
    const auto pressed = pressed_nodes(problem, result.active);
    area = contact_areas(mesh, problem.geometry, pressed);
    const Eigen::VectorXd load = whole_load(problem, cells, exposed_edges(mesh, pressed));
    Held held = hold_nodes(problem, result.active);
    if (!support(problem, load, result.active, held)) {
      result.reason = "the glass is not held: no tool, symmetry plane or fixed piece carries it";
      return result;
    }
    held.drag = friction_drag(problem, result.active, area, instant ? &*instant : nullptr);
    const auto columns = corrector.correct(problem, cells, held, load, iterate);
    result.factorisations = corrector.factorisations;
    if (!columns || !columns->allFinite()) {
      result.reason = "the flow matrix is singular: the glass is not held";
      return result;
    }
    Eigen::MatrixXd solution = *columns, force = product(mesh, cells, solution);
    solution.col(0) += iterate.x - solution.rightCols(iterate.driven.size()) * iterate.driven;
    force.col(0) += iterate.force - force.rightCols(iterate.driven.size()) * iterate.driven;
    Eigen::MatrixXd reaction = force.topRows(velocities);
    reaction.col(0) -= load.head(velocities);
    instant = combine(problem, held.frames, solution, reaction);
    for (std::size_t k = 0; k < driven.size(); ++k) iterate.driven[Index(k)] = instant->tool_velocity[driven[k]];
    const double moved = (instant->unknowns - iterate.x).head(velocities).norm();
    iterate.x = instant->unknowns;
    iterate.force = force.col(0) + force.rightCols(iterate.driven.size()) * iterate.driven;
    const bool steady = linear || moved <= same_flow * iterate.x.head(velocities).norm();
    if (problem.material->shear_thinning && !steady) {
      viscosity = viscosity_field(problem, iterate.x.head(velocities));
      cells = cell_matrices(problem, viscosity);
      iterate.force = product(mesh, cells, iterate.x);
      corrector.forget();
    }
    if (update_set(problem, *instant, result.active, releases) || !steady)
      refined = false;
    else if (!refined && imbalance(problem, cells, held, load, iterate) > balanced)
      refined = true;
    else
      settled = true;
  }
  result.velocity = instant->unknowns.head(velocities);
  result.pressure = instant->unknowns.tail(mesh.vertex_count);
  result.contact_pressure = contact_pressure(problem, result.active, instant->forces.normal, area);
  result.tool_velocity = instant->tool_velocity;
  result.tool_force.assign(problem.tools.size(), 0.0);
  for (std::size_t i = 0; i < problem.candidates.size(); ++i)
    result.tool_force[problem.candidates[i].tool] += instant->forces.axial[i];
  evaluate_dissipation(problem, viscosity, result);
  result.converged = true;
  return result;
}

}  // namespace parison::flow
