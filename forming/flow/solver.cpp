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

constexpr int max_iterations = 200;
/// Of a force, or a volume flow, against the products that make it up.
constexpr double residual_tolerance = 1e-12;
/// Where viscosity or friction depend on the flow, the change of the velocities at which they are found, relative.
constexpr double same_flow = 1e-6;

/// What does not change while the contacts are searched for.
struct Discrete {
  CellGeometry geometry;
  std::vector<SurfaceEdge> surface;
  std::vector<double> viscosity;
  CellMatrices cells;               ///< that give the forces of a flow
  CellMatrices tangent;             ///< that give their changes, where the viscosity depends on the flow
  Eigen::VectorXd dilatation_load;  ///< load of a change of volume at 1/s
  Eigen::VectorXd load;             ///< of gravity and the wanted change of volume, on every unknown
};

/// Viscosity and cells for a velocity, which may be empty.
void find_cells(const Problem& problem, const Eigen::VectorXd& velocity, Discrete& discrete) {
  discrete.viscosity = viscosity_field(problem, discrete.geometry, velocity);
  discrete.cells = cell_matrices(problem, discrete.geometry, discrete.viscosity);
}

/// The load of a change of volume at 1/s; glass that a tool holds cannot take part.
Eigen::VectorXd dilatation_load(const Problem& problem, const CellGeometry& geometry) {
  const auto& mesh = *problem.mesh;
  const auto& rule = core::triangle_rule(4);
  const Index velocities = dim * mesh.node_count();
  Eigen::VectorXd load = Eigen::VectorXd::Zero(velocities + mesh.vertex_count());
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (int q = 0; q < cell_points; ++q) {
      const double linear[3] = {1 - rule[q].a - rule[q].b, rule[q].a, rule[q].b};
      const double volume = geometry.at(c / batch_size, q).volume[c % batch_size];
      for (int p = 0; p < 3; ++p) load[velocities + mesh.cells()[c][p]] -= linear[p] * volume;
    }
  for (const auto& candidate : problem.candidates)
    if (candidate.tied && candidate.node < mesh.vertex_count()) load[velocities + candidate.node] = 0;
  return load;
}

Discrete discretise(const Problem& problem) {
  const auto& mesh = *problem.mesh;
  Discrete discrete{cell_geometry(mesh, problem.geometry), surface_edges(problem), {}, {}, {}, {}, {}};
  find_cells(problem, {}, discrete);
  discrete.dilatation_load = dilatation_load(problem, discrete.geometry);
  discrete.load = cell_loads(mesh, discrete.cells) + problem.volume_rate * discrete.dilatation_load;
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
Superposed superpose(const Problem& problem, const CellMatrices& cells, const Constraints& constraints,
                     const Eigen::VectorXd& load, Eigen::MatrixXd correction, const Iterate& iterate) {
  const core::Mesh& mesh = *problem.mesh;
  const Index velocities = dim * mesh.node_count(), driven = Index(iterate.driven.size());
  Superposed result{std::move(correction), {}};
  result.reaction = product(mesh, cells, result.unknowns, constrained_batches(mesh, constraints)).topRows(velocities);
  result.reaction.col(0) += iterate.force.head(velocities) - load.head(velocities);
  result.reaction.col(0) -= result.reaction.rightCols(driven) * iterate.driven;
  result.unknowns.col(0) += iterate.x - result.unknowns.rightCols(driven) * iterate.driven;
  return result;
}

/// The result from the last iterate; `dilatation_velocity` is what of its velocity has no part in the stress.
void report(const Problem& problem, const Discrete& discrete, const Constraints& constraints, const Instant& instant,
            const Eigen::VectorXd& dilatation_velocity, Solution& result) {
  const auto& mesh = *problem.mesh;
  const Index vertices = mesh.vertex_count();
  const auto in_contact = nodes_in_contact(problem, result.active);
  const Eigen::VectorXd area = contact_areas(mesh, discrete.surface, in_contact);
  result.velocity = instant.unknowns.head(instant.unknowns.size() - vertices);
  result.pressure = instant.unknowns.tail(vertices);
  result.contact_pressure = contact_pressure(problem, result.active, instant.forces.normal, area);
  result.tool_velocity = instant.tool_velocity;
  result.tool_force.assign(problem.tools.size(), 0.0);
  for (std::size_t i = 0; i < problem.candidates.size(); ++i)
    result.tool_force[problem.candidates[i].tool] += instant.forces.axial[i];
  // Stress times rate of deformation; the square of what dilatation alone would dissipate is nothing beside it.
  evaluate_dissipation(problem, discrete.geometry, discrete.viscosity, result.velocity - 0.5 * dilatation_velocity,
                       result);
  result.friction_power = friction_power(constraints, instant);
  result.impact_power = impact_power(problem, result.active, instant.forces);
  result.correction_power =
      correction_power(problem, result.active, instant.forces, result.pressure, discrete.load.tail(vertices));
  for (const auto& edge : mesh.boundary_edges())
    result.exposed.push_back(!(in_contact[edge.nodes[0]] && in_contact[edge.nodes[1]] && in_contact[edge.nodes[2]]));
  result.converged = true;
}

/// What a change of volume at 1/s does with the nodes held as in the solved problem, but at rest: a tool in balance
/// gives way without a force, one at its speed limit or told where to go stays. `superposed` tells what driven tools
/// do.
std::optional<Instant> find_dilatation_mode(Problem problem, const CellMatrices& cells, const Constraints& constraints,
                                            const Corrector& corrector, const std::vector<double>& tool_velocity,
                                            Superposed superposed) {
  for (std::size_t t = 0; t < problem.tools.size(); ++t) {
    ToolMotion& tool = problem.tools[t];
    tool.velocity = 0;
    if (!tool.force) continue;
    tool.force = 0;
    tool.speed_limit = std::abs(tool_velocity[t]) < tool.speed_limit ? std::numeric_limits<double>::infinity() : 0;
  }
  const auto additional = corrector.additional_solution(problem, constraints);
  if (!additional || !additional->allFinite()) return std::nullopt;
  const core::Mesh& mesh = *problem.mesh;
  superposed.unknowns.col(0) = *additional;
  superposed.reaction.col(0) =
      product(mesh, cells, *additional, constrained_batches(mesh, constraints)).topRows(dim * mesh.node_count());
  Instant instant = balance_tools(problem, constraints.nodes, superposed.unknowns, superposed.reaction);
  if (!instant.unknowns.allFinite()) return std::nullopt;
  return instant;
}

/// Gives the motion as much dilatation as it wants and takes what dilatation does out of forces and pressures, so that
/// it leaves no trace in the stress. Returns the dilatation's velocities, m/s.
Eigen::VectorXd apply_volume_correction(const Problem& problem, const Instant& mode, Discrete& discrete,
                                        Instant& instant, Solution& result) {
  const Index velocities = dim * problem.mesh->node_count(), vertices = problem.mesh->vertex_count();
  result.dilatation_mode = mode.unknowns.head(velocities);
  const double known = problem.volume_rate;
  const double more = problem.volume_correction(instant.unknowns.head(velocities), result.dilatation_mode);
  discrete.load += more * discrete.dilatation_load;
  instant.unknowns.head(velocities) += more * result.dilatation_mode;
  for (std::size_t t = 0; t < instant.tool_velocity.size(); ++t)
    instant.tool_velocity[t] += more * mode.tool_velocity[t];
  instant.unknowns.tail(vertices) -= known * mode.unknowns.tail(vertices);
  instant.forces.normal -= known * mode.forces.normal;
  instant.forces.axial -= known * mode.forces.axial;
  instant.forces.sideways -= known * mode.forces.sideways;
  return (known + more) * result.dilatation_mode;
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
  const Index velocities = dim * mesh.node_count(), size = velocities + mesh.vertex_count();
  Solution result;
  result.reason = free_motion(problem);
  if (!result.reason.empty()) return result;
  if (driven_tools(problem).size() > max_driven_tools)
    return failed(std::move(result), "more than four tools are driven by force at a time");
  result.active = initial_active_set(problem, warm);
  std::vector<int> releases(result.active.size(), 0);
  Discrete discrete = discretise(problem);
  corrector.start(problem.volume_correction ? discrete.dilatation_load : Eigen::VectorXd());
  Iterate iterate{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size),
                  Eigen::VectorXd::Zero(Index(driven_tools(problem).size()))};
  const bool linear = is_linear(problem), thinning = problem.material->shear_thinning.has_value();
  if (thinning) discrete.tangent = discrete.cells;
  const CellMatrices& tangent = thinning ? discrete.tangent : discrete.cells;
  NewtonGuard guard;
  Sliding sliding(result.active.size());
  std::optional<Instant> instant;
  Superposed superposed;
  Constraints constraints;
  for (bool converged = false, refined = false; !converged;) {
    if (result.iterations++ == max_iterations) return failed(std::move(result), "the contact set did not converge");
    const auto in_contact = nodes_in_contact(problem, result.active);
    const Eigen::VectorXd area = contact_areas(mesh, discrete.surface, in_contact);
    Eigen::VectorXd load = discrete.load;
    load.head(velocities) += surface_load(mesh, discrete.surface, in_contact);
    constraints = make_constraints(problem, result.active);
    if (!support(problem, load, result.active, constraints))
      return failed(
          std::move(result),
          "the glass is not held: no tool, symmetry plane or fixed boundary carries it (a fall is not computed: "
          "glass has to touch a tool)");
    add_friction(problem, result.active, area, instant ? &*instant : nullptr, sliding, constraints);
    auto correction = corrector.correct(problem, tangent, constraints, load, iterate);
    result.factorisations = corrector.factorisations;
    if (!correction || !correction->allFinite())
      return failed(std::move(result), "the flow matrix is singular: the glass is not held");
    const Eigen::VectorXd before = iterate.x.head(velocities);
    superposed = superpose(problem, tangent, constraints, load, std::move(*correction), iterate);
    instant = balance_tools(problem, constraints.nodes, superposed.unknowns, superposed.reaction);
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
    const auto change = update_active_set(problem, *instant, result.active, releases);
    result.contact_changes += change.changed;
    result.locked = change.locked;
    if (change.changed > 0 || !steady) {
      refined = false;
      iterate.force = product(mesh, discrete.cells, iterate.x);
    } else if (!refined && imbalance(problem, discrete.cells, constraints, load, iterate) > residual_tolerance) {
      refined = true;
    } else {
      converged = true;
    }
  }
  Eigen::VectorXd dilatation_velocity = Eigen::VectorXd::Zero(velocities);
  if (problem.volume_correction)
    if (const auto unit = find_dilatation_mode(problem, tangent, constraints, corrector, instant->tool_velocity,
                                               std::move(superposed)))
      dilatation_velocity = apply_volume_correction(problem, *unit, discrete, *instant, result);
  report(problem, discrete, constraints, *instant, dilatation_velocity, result);
  return result;
}

}  // namespace parison::flow
