// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/flow/solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/element.hpp"
#include "forming/flow/active_set.hpp"
#include "forming/flow/balance.hpp"
#include "forming/flow/cells/element_matrix.hpp"
#include "forming/flow/constraints.hpp"
#include "forming/flow/linear/schur_update.hpp"
#include "forming/flow/surface.hpp"

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
  CellMatrices cells;        ///< that give the forces of a flow
  CellMatrices tangent;      ///< that give their changes, where the viscosity depends on the flow
  Eigen::VectorXd swelling;  ///< load of a change of volume at 1/s
  Eigen::VectorXd load;      ///< of gravity and the wanted change of volume, on every unknown
};

/// Viscosity and cells for a velocity, which may be empty.
void find_cells(const Problem& problem, const Eigen::VectorXd& velocity, Discrete& discrete) {
  discrete.viscosity = viscosity_field(problem, discrete.geometry, velocity);
  discrete.cells = cell_matrices(problem, discrete.geometry, discrete.viscosity);
}

/// The load of a change of volume at 1/s; glass that a tool holds cannot take part.
Eigen::VectorXd swelling_load(const Problem& problem, const CellGeometry& geometry) {
  const auto& mesh = *problem.mesh;
  const auto& rule = core::triangle_rule(4);
  const Index velocities = dim * mesh.node_count();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(velocities + mesh.vertex_count);
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < cell_points; ++q) {
      const double linear[3] = {1 - rule[q].a - rule[q].b, rule[q].a, rule[q].b};
      const double volume = geometry.at(c / lanes, q).volume[c % lanes];
      for (int p = 0; p < 3; ++p) load[velocities + mesh.cells[c][p]] -= linear[p] * volume;
    }
  for (const auto& candidate : problem.candidates)
    if (candidate.held && candidate.node < mesh.vertex_count) load[velocities + candidate.node] = 0;
  return load;
}

Discrete discretise(const Problem& problem) {
  const auto& mesh = *problem.mesh;
  Discrete discrete{cell_geometry(mesh, problem.geometry), surface_edges(problem), {}, {}, {}, {}, {}};
  find_cells(problem, {}, discrete);
  discrete.swelling = swelling_load(problem, discrete.geometry);
  discrete.load = cell_loads(mesh, discrete.cells) + problem.volume_rate * discrete.swelling;
  return discrete;
}

/// Whether neither viscosity nor friction depends on the flow.
bool is_linear(const Problem& problem) {
  return !problem.material->shear_thinning &&
         std::none_of(problem.tools.begin(), problem.tools.end(),
                      [](const ToolMotion& tool) { return tool.friction.coulomb.has_value(); });
}

/// Velocities and pressures, and the forces at held nodes: column 0 with the driven tools at rest, column 1 + k for
/// each m/s of driven tool k.
struct Superposed {
  Eigen::MatrixXd unknowns, reaction;
};

/// The iterate with the correction; its force is the one before.
Superposed superpose(const Problem& problem, const CellMatrices& cells, const Held& held, const Eigen::VectorXd& load,
                     Eigen::MatrixXd correction, const Iterate& iterate) {
  const core::Mesh& mesh = *problem.mesh;
  const Index velocities = dim * mesh.node_count(), driven = iterate.driven.size();
  Superposed result{std::move(correction), {}};
  result.reaction = product(mesh, cells, result.unknowns, held_batches(mesh, held)).topRows(velocities);
  result.reaction.col(0) += iterate.force.head(velocities) - load.head(velocities);
  result.reaction.col(0) -= result.reaction.rightCols(driven) * iterate.driven;
  result.unknowns.col(0) += iterate.x - result.unknowns.rightCols(driven) * iterate.driven;
  return result;
}

/// The result from the last iterate; `swelling` is what of its velocity has no part in the stress.
void report(const Problem& problem, const Discrete& discrete, const Held& held, const Instant& instant,
            const Eigen::VectorXd& swelling, Solution& result) {
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
  // Stress times rate of deformation; the square of what swelling alone would dissipate is nothing beside it.
  evaluate_dissipation(problem, discrete.geometry, discrete.viscosity, result.velocity - 0.5 * swelling, result);
  result.friction_power = friction_power(held, instant);
  result.arrival_power = arrival_power(problem, result.active, instant.forces);
  result.correction_power =
      correction_power(problem, result.active, instant.forces, result.pressure, discrete.load.tail(vertices));
  for (const auto& edge : mesh.boundary)
    result.exposed.push_back(!(pressed[edge.nodes[0]] && pressed[edge.nodes[1]] && pressed[edge.nodes[2]]));
  result.converged = true;
}

/// What a change of volume at 1/s does with the nodes held as in the solved problem, but at rest: a tool in balance
/// gives way without a force, one at its speed limit or told where to go stays. `superposed` tells what driven tools
/// do.
std::optional<Instant> find_swelling(Problem problem, const CellMatrices& cells, const Held& held,
                                     const Corrector& corrector, const std::vector<double>& tool_velocity,
                                     Superposed superposed) {
  for (std::size_t t = 0; t < problem.tools.size(); ++t) {
    ToolMotion& tool = problem.tools[t];
    tool.velocity = 0;
    if (!tool.force) continue;
    tool.force = 0;
    tool.speed_limit = std::abs(tool_velocity[t]) < tool.speed_limit ? std::numeric_limits<double>::infinity() : 0;
  }
  const auto answer = corrector.answer_beside(problem, held);
  if (!answer || !answer->allFinite()) return std::nullopt;
  const core::Mesh& mesh = *problem.mesh;
  superposed.unknowns.col(0) = *answer;
  superposed.reaction.col(0) = product(mesh, cells, *answer, held_batches(mesh, held)).topRows(dim * mesh.node_count());
  Instant instant = balance_tools(problem, held.frames, superposed.unknowns, superposed.reaction);
  if (!instant.unknowns.allFinite()) return std::nullopt;
  return instant;
}

/// Gives the motion as much swelling as it wants and takes what swelling does out of forces and pressures, so that it
/// leaves no trace in the stress. Returns the swelling's velocities, m/s.
Eigen::VectorXd swell(const Problem& problem, const Instant& swelling, Discrete& discrete, Instant& instant,
                      Solution& result) {
  const Index velocities = dim * problem.mesh->node_count(), vertices = problem.mesh->vertex_count;
  result.swelling = swelling.unknowns.head(velocities);
  const double known = problem.volume_rate;
  const double more = problem.more_swelling(instant.unknowns.head(velocities), result.swelling);
  discrete.load += more * discrete.swelling;
  instant.unknowns.head(velocities) += more * result.swelling;
  for (std::size_t t = 0; t < instant.tool_velocity.size(); ++t)
    instant.tool_velocity[t] += more * swelling.tool_velocity[t];
  instant.unknowns.tail(vertices) -= known * swelling.unknowns.tail(vertices);
  instant.forces.normal -= known * swelling.forces.normal;
  instant.forces.axial -= known * swelling.forces.axial;
  instant.forces.sideways -= known * swelling.forces.sideways;
  return (known + more) * result.swelling;
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
  if (driven_tools(problem).size() > most_driven)
    return failed(std::move(result), "more than four tools are driven by force at a time");
  result.active = first_set(problem, warm);
  std::vector<int> releases(result.active.size(), 0);
  Discrete discrete = discretise(problem);
  corrector.start(problem.more_swelling ? discrete.swelling : Eigen::VectorXd());
  Iterate iterate{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size),
                  Eigen::VectorXd::Zero(Index(driven_tools(problem).size()))};
  const bool linear = is_linear(problem), thinning = problem.material->shear_thinning.has_value();
  if (thinning) discrete.tangent = discrete.cells;
  const CellMatrices& tangent = thinning ? discrete.tangent : discrete.cells;
  NewtonGuard guard;
  Sliding sliding(result.active.size());
  std::optional<Instant> instant;
  Superposed superposed;
  Held held;
  for (bool settled = false, refined = false; !settled;) {
    if (result.iterations++ == most_iterations) return failed(std::move(result), "the contact set did not settle");
    const auto pressed = pressed_nodes(problem, result.active);
    const Eigen::VectorXd area = contact_areas(mesh, discrete.surface, pressed);
    Eigen::VectorXd load = discrete.load;
    load.head(velocities) += surface_load(mesh, discrete.surface, pressed);
    held = hold_nodes(problem, result.active);
    if (!support(problem, load, result.active, held))
      return failed(std::move(result),
                    "the glass is not held: no tool, symmetry plane or fixed piece carries it (a fall is not computed: "
                    "glass has to touch a tool)");
    add_friction(problem, result.active, area, instant ? &*instant : nullptr, sliding, held);
    auto correction = corrector.correct(problem, tangent, held, load, iterate);
    result.factorisations = corrector.factorisations;
    if (!correction || !correction->allFinite())
      return failed(std::move(result), "the flow matrix is singular: the glass is not held");
    const Eigen::VectorXd before = iterate.x.head(velocities);
    superposed = superpose(problem, tangent, held, load, std::move(*correction), iterate);
    instant = balance_tools(problem, held.frames, superposed.unknowns, superposed.reaction);
    iterate.x = instant->unknowns;
    const auto tools = driven_tools(problem);
    for (std::size_t k = 0; k < tools.size(); ++k) iterate.driven[Index(k)] = instant->tool_velocity[tools[k]];
    const double moved = (iterate.x.head(velocities) - before).norm() / iterate.x.head(velocities).norm();
    const bool steady = linear || !(moved > same_flow);
    if (thinning) find_cells(problem, iterate.x.head(velocities), discrete);
    if (thinning && !steady) {
      discrete.tangent = discrete.cells;
      if (guard.trusts(moved))
        add_thinning_derivative(problem, discrete.geometry, discrete.viscosity, iterate.x.head(velocities),
                                discrete.tangent);
      corrector.forget();
    }
    const auto change = update_set(problem, *instant, result.active, releases);
    result.contact_changes += change.changed;
    result.latched = change.latched;
    if (change.changed > 0 || !steady) {
      refined = false;
      iterate.force = product(mesh, discrete.cells, iterate.x);
    } else if (!refined && imbalance(problem, discrete.cells, held, load, iterate) > balanced) {
      refined = true;
    } else {
      settled = true;
    }
  }
  Eigen::VectorXd swelling = Eigen::VectorXd::Zero(velocities);
  if (problem.more_swelling)
    if (const auto unit =
            find_swelling(problem, tangent, held, corrector, instant->tool_velocity, std::move(superposed)))
      swelling = swell(problem, *unit, discrete, *instant, result);
  report(problem, discrete, held, *instant, swelling, result);
  return result;
}

}  // namespace parison::flow
