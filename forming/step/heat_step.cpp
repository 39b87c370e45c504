// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat_step.hpp"

#include <algorithm>
#include <utility>

#include "forming/state/initial_state.hpp"
#include "forming/step/thermal_interface.hpp"
#include "remesh/surface/wall_thickness.hpp"

namespace parison::forming {

namespace {

/// The exchange with cooling or air of a boundary of a body's mesh. Those that a stage names come behind the outline's.
std::optional<thermal::SurfaceExchange> exchange_of(const Body& body, const core::Mesh& mesh, std::size_t boundary,
                                                    const Stage& stage) {
  const BoundaryKind kind = mesh.boundaries()[boundary].kind;
  if (kind == BoundaryKind::cooled) return body.boundaries[boundary].cooling;
  if (kind != BoundaryKind::contact && kind != BoundaryKind::air) return std::nullopt;
  thermal::SurfaceExchange exchange = stage.air;
  exchange.emissivity = body.emissivity;
  if (exchange.h.max() == 0 && exchange.emissivity == 0) return std::nullopt;
  return exchange;
}

std::optional<core::TimeFunction> prescribed_of(const Body& body, const core::Mesh& mesh, std::size_t boundary) {
  if (mesh.boundaries()[boundary].kind != BoundaryKind::temperature) return std::nullopt;
  return body.boundaries[boundary].temperature;
}

thermal::BodyView view_of(const Scene& scene, Index body, const core::Mesh& mesh, const Stage& stage) {
  const Body& data = body_of(scene, body);
  thermal::BodyView view{&mesh, &mesh, data.thermal->density, &*data.thermal, {}, {}};
  for (std::size_t boundary = 0; boundary < mesh.boundaries().size(); ++boundary) {
    view.exchange.push_back(exchange_of(data, mesh, boundary, stage));
    view.prescribed.push_back(prescribed_of(data, mesh, boundary));
  }
  return view;
}

/// What Newton may leave in the equations of heat, of the error allowed to the step.
constexpr double newton_fraction = 1e-3;

bool limits_radiation(const Scene& scene) {
  const auto& radiation = scene.glass.thermal->radiation;
  return radiation && radiation->thin_wall;
}

using Meshes = std::vector<const core::Mesh*>;

thermal::Problem make_problem(const Scene& scene, const State& state, const Meshes& meshes,
                              const std::vector<core::InterfacePoint>& interface, long& clamped_lookups) {
  const Stage& stage = scene.stages[state.stage];
  thermal::Problem problem{scene.geometry, {}, interface, {}, scene.accuracy.temperature_order};
  for (Index b = 0; b < static_cast<Index>(meshes.size()); ++b)
    problem.bodies.push_back(view_of(scene, b, *meshes[b], stage));
  problem.bodies[0].density = state.glass.density;
  problem.law = interface_law(scene, problem.interface, clamped_lookups);
  return problem;
}

/// Accumulates a heat balance in the state; bodies are numbered alike in both.
void accumulate(const thermal::HeatBalance& balance, State& state) {
  state.totals.to_air += balance.bodies[0].to_air - balance.bodies[0].from_prescribed;
  state.totals.dissipation += balance.bodies[0].from_source;
  state.totals.to_tools += thermal::lost_through_interfaces(balance, 0);
  state.totals.max_flux_mismatch = std::max(state.totals.max_flux_mismatch, thermal::flux_mismatch(balance));
  for (std::size_t t = 0; t < state.tools.size(); ++t)
    state.tools[t].heat_received -= thermal::lost_through_interfaces(balance, body_of_tool(Index(t)));
}

void update_max_surface_temperatures(const Scene& scene, State& state) {
  for (auto& body : state.tools) {
    const auto touches = core::boundaries_of_kind(body.mesh, BoundaryKind::contact);
    for (const auto& edge : body.mesh.boundary_edges())
      if (touches[edge.boundary_id])
        for (const Index node : edge.nodes)
          body.max_surface_temperature = std::max(body.max_surface_temperature, body.temperature[node]);
  }
}

void update_overshoot(const Scene& scene, State& state) {
  const double max_temperature = temperature_range(scene).max_temperature;
  for (Index body = 0; body < body_count(state); ++body)
    if (const auto& temperature = temperature_of(state, body); temperature.size() > 0)
      state.totals.overshoot = std::max(state.totals.overshoot, temperature.maxCoeff() - max_temperature);
}

void store_temperatures(State& state, std::vector<Eigen::VectorXd> temperature) {
  for (Index b = 0; b < body_count(state); ++b) temperature_of(state, b) = std::move(temperature[b]);
}

std::vector<Eigen::VectorXd> temperatures(const State& state) {
  std::vector<Eigen::VectorXd> result;
  for (Index b = 0; b < body_count(state); ++b) result.push_back(temperature_of(state, b));
  return result;
}

void store_couplings(State& state, const std::vector<thermal::Coupling>& couplings) {
  state.heat_couplings.clear();
  for (const auto& coupling : couplings)
    state.heat_couplings.insert(state.heat_couplings.end(), coupling.begin(), coupling.end());
}

std::vector<thermal::Coupling> couplings_of(const State& state) {
  std::vector<thermal::Coupling> couplings(state.heat_couplings.size() / 4);
  for (std::size_t i = 0; i < state.heat_couplings.size(); ++i) couplings[i / 4][i % 4] = state.heat_couplings[i];
  return couplings;
}

Meshes meshes_of(const State& state) {
  Meshes meshes;
  for (Index b = 0; b < body_count(state); ++b) meshes.push_back(&mesh_of(state, b));
  return meshes;
}

/// Whether glass and tools stand still for the whole stage.
bool is_static(const Scene& scene, const Stage& stage) {
  return !scene.has_flow() && std::all_of(stage.tools.begin(), stage.tools.end(), [](const auto& tool) {
    return std::holds_alternative<std::monostate>(tool.motion);
  });
}

/// Steps after which the integrator of a static stage starts anew, for a checkpoint to be possible: some seconds of
/// work.
constexpr long max_inner_steps = 300;

/// Whether the integrator is to start anew: after steps that depend on the case alone, never on the clock.
bool is_expired(const Scene& scene, const Workspace::StaticStage& static_stage) {
  const auto& steps = scene.output.checkpoint_steps;
  return static_stage.inner_steps >= max_inner_steps || (steps && static_stage.steps >= *steps);
}

HeatOutcome advance_static_stage(const Scene& scene, State& state, const std::vector<core::InterfacePoint>& interface,
                                 double dt, Workspace& workspace) {
  auto& static_stage = workspace.static_stage;
  if (!static_stage || static_stage->stage != state.stage || static_stage->expired) {
    static_stage = std::make_unique<Workspace::StaticStage>();
    static_stage->stage = state.stage;
    for (Index b = 0; b < body_count(state); ++b) static_stage->meshes.push_back(mesh_of(state, b));
    Meshes meshes;
    for (const auto& mesh : static_stage->meshes) meshes.push_back(&mesh);
    auto problem = make_problem(scene, state, meshes, interface, workspace.clamped_lookups);
    if (limits_radiation(scene)) {
      static_stage->thickness = {remesh::wall_thickness(
          static_stage->meshes[0], core::boundaries_of_kind(static_stage->meshes[0], BoundaryKind::symmetry))};
      problem.bodies[0].wall_thickness = &static_stage->thickness[0];
    }
    thermal::IdaOptions options;
    options.tolerance = scene.accuracy.temperature_tolerance;
    static_stage->integrator.emplace(std::move(problem), state.time, temperatures(state), options);
  }
  auto outcome = static_stage->integrator->advance_to(state.time + dt);
  if (!outcome.converged) {
    static_stage.reset();
    return {false, outcome.reason};
  }
  static_stage->inner_steps += outcome.steps;
  ++static_stage->steps;
  static_stage->expired = is_expired(scene, *static_stage);
  store_temperatures(state, std::move(outcome.temperature));
  accumulate(outcome.balance, state);
  return {true, "", static_cast<int>(outcome.steps)};
}

}  // namespace

HeatOutcome advance_heat(const Scene& scene, State& state, const std::vector<core::InterfacePoint>& interface,
                         const std::vector<double>& dissipation, double dt, Workspace& workspace) {
  HeatOutcome result;
  if (is_static(scene, scene.stages[state.stage])) {
    result = advance_static_stage(scene, state, interface, dt, workspace);
  } else {
    workspace.static_stage.reset();
    const auto meshes = meshes_of(state);
    const core::Mesh mass = mass_mesh(state);
    auto problem = make_problem(scene, state, meshes, interface, workspace.clamped_lookups);
    problem.bodies[0].mass_mesh = &mass;
    if (!dissipation.empty()) problem.bodies[0].source = &dissipation;
    Eigen::VectorXd thickness;
    if (limits_radiation(scene)) {
      thickness = remesh::wall_thickness(*meshes[0], core::boundaries_of_kind(*meshes[0], BoundaryKind::symmetry));
      problem.bodies[0].wall_thickness = &thickness;
    }
    thermal::StepOptions options;
    options.tolerance = scene.accuracy.temperature_tolerance;
    options.newton_tolerance = newton_fraction * options.tolerance;
    options.initial_substep = state.heat_substep;
    workspace.heat.couplings = couplings_of(state);
    auto outcome = thermal::advance(problem, state.time, temperatures(state), dt, options, workspace.heat);
    if (!outcome.converged) return {false, outcome.reason};
    store_couplings(state, workspace.heat.couplings);
    store_temperatures(state, std::move(outcome.temperature));
    accumulate(outcome.balance, state);
    state.heat_substep = outcome.next_substep;
    result = {true, "", static_cast<int>(outcome.substeps)};
  }
  if (!result.converged) return result;
  update_max_surface_temperatures(scene, state);
  update_overshoot(scene, state);
  return result;
}

}  // namespace parison::forming
