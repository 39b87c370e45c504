// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat/heat_step.hpp"

#include <algorithm>
#include <utility>

#include "forming/state/initial_state.hpp"
#include "forming/step/heat/surroundings.hpp"
#include "forming/step/heat/thermal_interface.hpp"
#include "remesh/surface/wall_thickness.hpp"

namespace parison::forming {

namespace {

std::optional<core::TimeFunction> prescribed_of(const Body& body, const core::Mesh& mesh, std::size_t boundary) {
  if (mesh.boundaries()[boundary].kind != BoundaryKind::temperature) return std::nullopt;
  return body.boundaries[boundary].temperature;
}

/// Local error of a step of IDA, as a fraction of that: where nothing moves it takes many small changes, whose errors
/// add up, and costs little.
constexpr double integrator_fraction = 0.2;

using Meshes = std::vector<const core::Mesh*>;  ///< by body

/// The heat problem of the present stage; its bodies are numbered as in the state, glass_body and body_of_tool.
thermal::Problem make_problem(const Scene& scene, const State& state, const Meshes& meshes,
                              const std::vector<core::InterfacePoint>& interface, long& clamped_lookups) {
  thermal::Problem problem{scene.geometry, {}, interface, {}};
  problem.light_resolution.rays = scene.accuracy.light_rays;
  for (Index b = 0; b < static_cast<Index>(meshes.size()); ++b)
    problem.bodies.push_back(body_view(scene, state, b, *meshes[b]));
  problem.enclosure = scene.enclosure;
  if (scene.has_light() || scene.enclosure)
    for (Index b = 0; b < static_cast<Index>(meshes.size()); ++b)
      problem.bodies[b].light = surface_light(scene, state, b, *meshes[b]);
  problem.bodies[glass_body].density = state.glass.density;
  if (scene.expands()) problem.bodies[glass_body].mass_temperature = &state.glass.mass_temperature;
  problem.law = interface_law(scene, problem.interface, state.time, clamped_lookups);
  return problem;
}

/// Accumulates the balance of such a problem in the state.
void accumulate(const thermal::HeatBalance& balance, State& state) {
  const thermal::BodyBalance& glass = balance.bodies[glass_body];
  state.totals.to_air += glass.to_air - glass.from_prescribed;
  state.totals.light_to_air += glass.light_to_air;
  state.totals.from_enclosure += glass.from_enclosure;
  state.totals.dissipation += glass.from_source;
  state.totals.to_tools += thermal::lost_through_interfaces(balance, glass_body);
  for (std::size_t t = 0; t < state.tools.size(); ++t) {
    const Index body = body_of_tool(Index(t));
    state.tools[t].heat_received -= thermal::lost_through_interfaces(balance, body);
    state.tools[t].heat_from_enclosure += balance.bodies[static_cast<std::size_t>(body)].from_enclosure;
    const auto first = static_cast<std::size_t>(balance.first_boundary[static_cast<std::size_t>(body)]);
    for (std::size_t i = 0; i < state.tools[t].heat_through.size(); ++i)
      state.tools[t].heat_through[i] += balance.through_boundary[first + i];
  }
  for (const thermal::PairBalance& pair : balance.pairs)
    state.tools[pair.master_body - 1].heat_radiated += pair.radiated;
}

/// Of all bodies but tools that wait for their first use.
void store_temperatures(const Scene& scene, State& state, std::vector<Eigen::VectorXd> temperature) {
  for (Index b = 0; b < body_count(state); ++b)
    if (b == glass_body || !is_waiting(scene, state.stage, b - body_of_tool(0)))
      temperature_of(state, b) = std::move(temperature[b]);
}

std::vector<Eigen::VectorXd> temperatures(const State& state) {
  std::vector<Eigen::VectorXd> result;
  result.reserve(body_count(state));
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

/// Wall thickness of the glass by node, m; empty where it does not limit the radiation.
Eigen::VectorXd limiting_wall_thickness(const Scene& scene, const core::Mesh& glass) {
  if (!thermal::is_rosseland(*scene.glass.thermal) || !scene.glass.thermal->radiation->thin_wall) return {};
  return remesh::wall_thickness(glass);
}

/// Whether glass, tools, the gaps between them and what the glass absorbs do not change for the whole stage.
bool is_static(const Scene& scene, const Stage& stage) {
  return !scene.has_flow() && !scene.has_gap_law() && !thermal::absorption_varies(*scene.glass.thermal) &&
         std::all_of(stage.tools.begin(), stage.tools.end(), [](const auto& tool) { return !tool.moves(); });
}

/// Steps of IDA, some seconds of work, after which a new integrator is started so that a checkpoint can be written.
constexpr long max_integrator_steps = 300;

/// Whether the next step starts a new integrator. This depends on the case alone and not on the clock, so that a
/// resumed run gives the same result.
bool is_expired(const Scene& scene, const StaticStage& static_stage) {
  const auto& steps = scene.output.checkpoint_steps;
  return static_stage.integrator_steps >= max_integrator_steps || (steps && static_stage.steps >= *steps);
}

std::unique_ptr<StaticStage> start_static_stage(const Scene& scene, const State& state,
                                                const std::vector<core::InterfacePoint>& interface,
                                                long& clamped_lookups) {
  auto result = std::make_unique<StaticStage>();
  result->stage = state.stage;
  for (Index b = 0; b < body_count(state); ++b) result->meshes.push_back(mesh_of(state, b));
  Meshes meshes;
  for (const auto& mesh : result->meshes) meshes.push_back(&mesh);
  auto problem = make_problem(scene, state, meshes, interface, clamped_lookups);
  result->wall_thickness = limiting_wall_thickness(scene, result->meshes[glass_body]);
  if (result->wall_thickness.size() > 0) problem.bodies[glass_body].wall_thickness = &result->wall_thickness;
  const thermal::IdaOptions options{integrator_fraction * temperature_tolerance(scene)};
  result->integrator.emplace(std::move(problem), state.time, temperatures(state), options);
  return result;
}

HeatOutcome advance_by_ida(const Scene& scene, State& state, const std::vector<core::InterfacePoint>& interface,
                           double dt, Workspace& workspace) {
  auto& static_stage = workspace.static_stage;
  if (!static_stage || static_stage->stage != state.stage || static_stage->expired)
    static_stage = start_static_stage(scene, state, interface, workspace.clamped_lookups);
  auto outcome = static_stage->integrator->advance_to(state.time + dt);
  if (!outcome.converged) {
    static_stage.reset();
    return {false, outcome.reason};
  }
  static_stage->integrator_steps += outcome.steps;
  ++static_stage->steps;
  static_stage->expired = is_expired(scene, *static_stage);
  store_temperatures(scene, state, std::move(outcome.temperature));
  accumulate(outcome.balance, state);
  return {true, "", static_cast<int>(outcome.steps), thermal::flux_mismatch(outcome.balance)};
}

/// What a moving heat problem points to.
struct MovingParts {
  Meshes meshes;
  core::Mesh mass;
  Eigen::VectorXd wall_thickness;
};

MovingParts moving_parts(const Scene& scene, const State& state) {
  return {meshes_of(state), mass_mesh(state), limiting_wall_thickness(scene, state.glass.mesh)};
}

/// The problem of a stage in which something moves; the parts and the state must outlive it.
thermal::Problem moving_problem(const Scene& scene, const State& state, const MovingParts& parts,
                                const std::vector<core::InterfacePoint>& interface, long& clamped_lookups) {
  auto problem = make_problem(scene, state, parts.meshes, interface, clamped_lookups);
  thermal::BodyView& glass = problem.bodies[glass_body];
  glass.mass_mesh = &parts.mass;
  if (parts.wall_thickness.size() > 0) glass.wall_thickness = &parts.wall_thickness;
  problem.traced = &state.light;
  return problem;
}

HeatOutcome advance_by_tr_bdf2(const Scene& scene, State& state, const std::vector<core::InterfacePoint>& interface,
                               const std::vector<double>& dissipation, double dt, Workspace& workspace) {
  workspace.static_stage.reset();
  const MovingParts parts = moving_parts(scene, state);
  auto problem = moving_problem(scene, state, parts, interface, workspace.clamped_lookups);
  if (!dissipation.empty()) problem.bodies[glass_body].source = &dissipation;
  const auto options = heat_options(scene, state.heat_substep);
  workspace.heat.couplings = couplings_of(state);
  auto outcome = thermal::advance(problem, state.time, temperatures(state), dt, options, workspace.heat);
  if (!outcome.converged) return {false, outcome.reason};
  store_couplings(state, workspace.heat.couplings);
  state.light = thermal::traced_places(workspace.heat.kept);
  store_temperatures(scene, state, std::move(outcome.temperature));
  accumulate(outcome.balance, state);
  state.heat_substep = outcome.next_substep;
  return {true, "", static_cast<int>(outcome.substeps), thermal::flux_mismatch(outcome.balance)};
}

}  // namespace

thermal::BodyView body_view(const Scene& scene, const State& state, Index body, const core::Mesh& mesh) {
  const Body& data = body_of(scene, body);
  thermal::BodyView view{&mesh, &mesh, data.thermal->density, &*data.thermal, {}, {}};
  if (body != glass_body && is_waiting(scene, state.stage, body - body_of_tool(0))) return view;
  view.exchange = surroundings(scene, state, body, mesh);
  for (std::size_t boundary = 0; boundary < mesh.boundaries().size(); ++boundary)
    view.prescribed.push_back(prescribed_of(data, mesh, boundary));
  return view;
}

double temperature_tolerance(const Scene& scene) {
  constexpr double of_span = 2e-3;
  const double span = temperature_range(scene).span(), tolerance = scene.accuracy.temperature_tolerance;
  return span > 0 ? std::min(tolerance, of_span * span) : tolerance;
}

thermal::StepOptions heat_options(const Scene& scene, double initial_substep) {
  constexpr double newton_fraction = 1e-3;  // algebraic error of a stage, of the local error
  const double tolerance = temperature_tolerance(scene);
  return {tolerance, newton_fraction * tolerance, initial_substep};
}

HeatRates heat_rates(const Scene& scene, const State& state) {
  const auto interface = thermal_interface(scene, state);
  const MovingParts parts = moving_parts(scene, state);
  long clamped_lookups = 0;
  auto problem = moving_problem(scene, state, parts, interface, clamped_lookups);
  problem.bodies[glass_body].absorption_at = &state.glass.temperature;
  const thermal::HeatSystem system = thermal::make_heat_system(problem);
  const thermal::Flows flows = thermal::evaluate_flows(system, state.time, thermal::join(system, temperatures(state)));
  const double light = flows.light_to_air[glass_body];
  const auto tools = static_cast<Eigen::Index>(state.tools.size());
  HeatRates rates{flows.to_air[glass_body] - light, light, Eigen::ArrayXd::Zero(tools), Eigen::ArrayXd::Zero(tools)};
  for (std::size_t p = 0; p < system.pairs.size(); ++p) {
    const auto pair = static_cast<Eigen::Index>(p);
    const Index tool = system.pairs[p].second - body_of_tool(0);
    rates.conducted[tool] += flows.across[pair] - flows.radiated[pair];
    rates.radiated[tool] += flows.radiated[pair];
  }
  return rates;
}

thermal::LightError light_error(const Scene& scene, const State& state,
                                const std::vector<core::InterfacePoint>& interface) {
  const MovingParts parts = moving_parts(scene, state);
  long clamped_lookups = 0;
  auto problem = moving_problem(scene, state, parts, interface, clamped_lookups);
  problem.bodies[glass_body].absorption_at = &state.glass.temperature;
  return thermal::light_error(problem, state.time, temperatures(state));
}

HeatOutcome advance_heat(const Scene& scene, State& state, const std::vector<core::InterfacePoint>& interface,
                         const std::vector<double>& dissipation, double dt, Workspace& workspace) {
  return is_static(scene, scene.stages[state.stage])
             ? advance_by_ida(scene, state, interface, dt, workspace)
             : advance_by_tr_bdf2(scene, state, interface, dissipation, dt, workspace);
}

}  // namespace parison::forming
