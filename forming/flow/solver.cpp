// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/solver.hpp"

#include <algorithm>

#include "forming/flow/contact_set.hpp"
#include "forming/flow/correction.hpp"
#include "forming/flow/losses.hpp"
#include "forming/flow/support.hpp"
#include "forming/flow/surface.hpp"
#include "forming/flow/thinning.hpp"

namespace parison::flow {

using core::dim;

namespace {

constexpr int most_iterations = 200;
/// Of a force, or a volume flow, against the products that make it up.
constexpr double balanced = 1e-12;
/// Where viscosity or friction depend on the flow, the change of the velocities at which they are found, relative.
constexpr double same_flow = 1e-6;

/// What does not change while the contacts are searched for.
struct Discrete {
  CellGeometry geometry;
  std::vector<SurfaceEdge> surface;
  std::vector<double> viscosity;
  CellMatrices cells;    ///< that give the forces of a flow
  CellMatrices tangent;  ///< that give their changes, where the viscosity depends on the flow
  Eigen::VectorXd load;  ///< of gravity and the wanted change of volume, on every unknown
};

/// Viscosity and cells for a velocity, which may be empty.
void find_cells(const Problem& problem, const Eigen::VectorXd& velocity, Discrete& discrete) {
  discrete.viscosity = viscosity_field(problem, discrete.geometry, velocity);
  discrete.cells = cell_matrices(problem, discrete.geometry, discrete.viscosity);
}

Discrete discretise(const Problem& problem) {
  const auto& mesh = *problem.mesh;
  Discrete discrete{cell_geometry(mesh, problem.geometry), surface_edges(problem), {}, {}, {}, {}};
  find_cells(problem, {}, discrete);
  discrete.load = cell_loads(mesh, discrete.cells);
  // Held glass cannot take part in a change of volume.
  for (const auto& candidate : problem.candidates)
    if (candidate.held && candidate.node < mesh.vertex_count) discrete.load[dim * mesh.node_count() + candidate.node] = 0;
  return discrete;
}

/// Whether neither viscosity nor friction depends on the flow.
bool is_linear(const Problem& problem) {
  return !problem.material->shear_thinning &&
         std::none_of(problem.tools.begin(), problem.tools.end(),
                      [](const ToolMotion& tool) { return tool.friction.coulomb.has_value(); });
}

/// Adds the correction to the iterate, with the driven tools in balance.
Instant advance(const Problem& problem, const CellMatrices& cells, const Held& held, const Eigen::VectorXd& load,
                Eigen::MatrixXd correction, Iterate& iterate) {
  const Index velocities = dim * problem.mesh->node_count(), driven = iterate.driven.size();
  Eigen::MatrixXd& solution = correction;
  Eigen::MatrixXd force = product(*problem.mesh, cells, solution);
  solution.col(0) += iterate.x - solution.rightCols(driven) * iterate.driven;
  force.col(0) += iterate.force - force.rightCols(driven) * iterate.driven;
  Eigen::MatrixXd reaction = force.topRows(velocities);
  reaction.col(0) -= load.head(velocities);
  Instant instant = balance_tools(problem, held.frames, solution, reaction);
  const auto tools = driven_tools(problem);
  for (Index k = 0; k < driven; ++k) iterate.driven[k] = instant.tool_velocity[tools[k]];
  iterate.x = instant.unknowns;
  iterate.force = force.col(0) + force.rightCols(driven) * iterate.driven;
  return instant;
}

/// The result from the last iterate.
void report(const Problem& problem, const Discrete& discrete, const Held& held, const Instant& instant, Solution& result) {
  const auto& mesh = *problem.mesh;
  const Index vertices = mesh.vertex_count;
  const auto pressed = pressed_nodes(problem, result.active);
  const Eigen::VectorXd area = contact_areas(mesh, discrete.surface, pressed);
  result.velocity = instant.unknowns.head(instant.unknowns.size() - vertices);
  result.pressure = instant.unknowns.tail(vertices);
  result.contact_pressure = contact_pressure(problem, result.active, instant.forces.normal, area);
  result.tool_velocity = instant.tool_velocity;
  result.tool_force.assign(problem.tools.size(), 0.0);
  for (std::size_t i = 0; i < problem.candidates.size(); ++i)
    result.tool_force[problem.candidates[i].tool] += instant.forces.axial[i];
  evaluate_dissipation(problem, discrete.geometry, discrete.viscosity, result);
  result.friction_power = friction_power(held, instant);
  result.arrival_power = arrival_power(problem, result.active, instant.forces);
  result.correction_power =
      correction_power(problem, result.active, instant.forces, result.pressure, discrete.load.tail(vertices));
  for (const auto& edge : mesh.boundary)
    result.exposed.push_back(!(pressed[edge.nodes[0]] && pressed[edge.nodes[1]] && pressed[edge.nodes[2]]));
  result.converged = true;
}

Solution failed(Solution result, const char* reason) {
  result.reason = reason;
  return result;
}

}  // namespace

struct Solver::Data : Corrector {
  using Corrector::Corrector;
};

Solver::Solver(const core::Mesh& mesh) : data_(std::make_unique<Data>(mesh)) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

Solution Solver::solve(const Problem& problem, const std::vector<bool>& warm) {
  auto& corrector = *data_;
  const auto& mesh = *problem.mesh;
  const Index velocities = dim * mesh.node_count(), size = velocities + mesh.vertex_count;
  Solution result;
  result.reason = free_motion(problem);
  if (!result.reason.empty()) return result;
  result.active = first_set(problem, warm);
  std::vector<int> releases(result.active.size(), 0);
  Discrete discrete = discretise(problem);
  corrector.forget();
  corrector.factorisations = 0;
  Iterate iterate{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size),
                  Eigen::VectorXd::Zero(Index(driven_tools(problem).size()))};
  const bool linear = is_linear(problem), thinning = problem.material->shear_thinning.has_value();
  if (thinning) discrete.tangent = discrete.cells;
  const CellMatrices& tangent = thinning ? discrete.tangent : discrete.cells;
  NewtonGuard guard;
  Sliding sliding(result.active.size());
  std::optional<Instant> instant;
  Held held;
  for (bool settled = false, refined = false; !settled;) {
    if (result.iterations++ == most_iterations) return failed(std::move(result), "the contact set did not settle");
    const auto pressed = pressed_nodes(problem, result.active);
    const Eigen::VectorXd area = contact_areas(mesh, discrete.surface, pressed);
    Eigen::VectorXd load = discrete.load;
    load.head(velocities) += surface_load(mesh, discrete.surface, pressed);
    held = hold_nodes(problem, result.active);
    if (!support(problem, load, result.active, held))
      return failed(std::move(result), "the glass is not held: no tool, symmetry plane or fixed piece carries it");
    add_friction(problem, result.active, area, instant ? &*instant : nullptr, sliding, held);
    auto correction = corrector.correct(problem, tangent, held, load, iterate);
    result.factorisations = corrector.factorisations;
    if (!correction || !correction->allFinite())
      return failed(std::move(result), "the flow matrix is singular: the glass is not held");
    const Eigen::VectorXd before = iterate.x.head(velocities);
    instant = advance(problem, tangent, held, load, std::move(*correction), iterate);
    const double moved = (iterate.x.head(velocities) - before).norm() / iterate.x.head(velocities).norm();
    const bool steady = linear || !(moved > same_flow);
    if (thinning) {
      find_cells(problem, iterate.x.head(velocities), discrete);
      iterate.force = product(mesh, discrete.cells, iterate.x);
    }
    if (thinning && !steady) {
      discrete.tangent = discrete.cells;
      if (guard.trusts(moved))
        add_thinning_derivative(problem, discrete.geometry, discrete.viscosity, iterate.x.head(velocities), discrete.tangent);
      corrector.forget();
    }
    const auto change = update_set(problem, *instant, result.active, releases);
    result.contact_changes += change.changed;
    result.latched = change.latched;
    if (change.changed > 0 || !steady)
      refined = false;
    else if (!refined && imbalance(problem, discrete.cells, held, load, iterate) > balanced)
      refined = true;
    else
      settled = true;
  }
  report(problem, discrete, held, *instant, result);
  return result;
}

}  // namespace parison::flow
