// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/heat_step.hpp"

#include <algorithm>
#include <utility>

#include "forming/state/initial_state.hpp"
#include "forming/step/thermal_interface.hpp"
#include "remesh/surface/wall_thickness.hpp"

namespace parison::forming {

namespace {

std::optional<thermal::SurfaceExchange> exchange_of(const Body& body, const std::string& piece, const Stage& stage) {
  for (const auto& known : body.pieces)
    if (known.name == piece && known.kind == PieceKind::cooled) return known.cooling;
  const PieceKind kind = piece_kind(body, piece);
  if (kind != PieceKind::contact && kind != PieceKind::air) return std::nullopt;
  thermal::SurfaceExchange exchange = stage.air;
  exchange.emissivity = body.emissivity;
  if (exchange.h == 0 && exchange.emissivity == 0) return std::nullopt;
  return exchange;
}

std::optional<double> prescribed_of(const Body& body, const std::string& piece) {
  for (const auto& known : body.pieces)
    if (known.name == piece && known.kind == PieceKind::temperature) return known.temperature;
  return std::nullopt;
}

thermal::BodyView view_of(const Scene& scene, Index body, const core::Mesh& mesh, const Stage& stage) {
  const Body& data = body_of(scene, body);
  thermal::BodyView view{&mesh, &mesh, data.thermal->density, &*data.thermal, {}, {}};
  for (const auto& piece : mesh.pieces) {
    view.exchange.push_back(exchange_of(data, piece, stage));
    view.prescribed.push_back(prescribed_of(data, piece));
  }
  return view;
}

/// What Newton may leave in the equations of heat, of the error allowed to the step.
constexpr double newton_share = 1e-3;

bool limits_radiation(const Scene& scene) {
  const auto& radiation = scene.glass.thermal->radiation;
  return radiation && radiation->thin_wall;
}

using Meshes = std::vector<const core::Mesh*>;

thermal::Problem make_problem(const Scene& scene, const State& state, const Meshes& meshes,
                              const std::vector<core::InterfacePoint>& interface, long& table_holds) {
  const Stage& stage = scene.stages[state.stage];
  thermal::Problem problem{scene.geometry, {}, interface, {}, scene.accuracy.temperature_order};
  for (Index b = 0; b < static_cast<Index>(meshes.size()); ++b)
    problem.bodies.push_back(view_of(scene, b, *meshes[b], stage));
  problem.bodies[0].density = state.density;
  problem.law = interface_law(scene, problem.interface, table_holds);
  return problem;
}

/// Books a heat ledger in the state; bodies are numbered alike in both.
void book(const thermal::Ledger& ledger, State& state) {
  state.totals.to_air += ledger.bodies[0].to_air - ledger.bodies[0].from_prescribed;
  state.totals.dissipation += ledger.bodies[0].from_source;
  state.totals.to_tools += thermal::lost_through_interfaces(ledger, 0);
  state.totals.largest_flux_mismatch = std::max(state.totals.largest_flux_mismatch, thermal::flux_mismatch(ledger));
  for (Index b = 1; b < static_cast<Index>(state.bodies.size()); ++b)
    state.bodies[b].heat_received -= thermal::lost_through_interfaces(ledger, b);
}

void note_hottest_surfaces(const Scene& scene, State& state) {
  for (Index b = 1; b < static_cast<Index>(state.bodies.size()); ++b) {
    auto& body = state.bodies[b];
    const auto touches = contact_pieces(body_of(scene, b), body.mesh);
    for (const auto& edge : body.mesh.boundary)
      if (touches[edge.piece])
        for (const Index node : edge.nodes)
          body.hottest_surface = std::max(body.hottest_surface, body.temperature[node]);
  }
}

void note_overshoot(const Scene& scene, State& state) {
  const double hottest = temperature_range(scene).hottest;
  for (const auto& body : state.bodies)
    if (body.temperature.size() > 0)
      state.totals.overshoot = std::max(state.totals.overshoot, body.temperature.maxCoeff() - hottest);
}

void take_temperatures(State& state, std::vector<Eigen::VectorXd> temperature) {
  for (std::size_t b = 0; b < temperature.size(); ++b) state.bodies[b].temperature = std::move(temperature[b]);
}

std::vector<Eigen::VectorXd> temperatures(const State& state) {
  std::vector<Eigen::VectorXd> result;
  for (const auto& body : state.bodies) result.push_back(body.temperature);
  return result;
}

void take_couplings(State& state, const std::vector<thermal::Coupling>& couplings) {
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
  for (const auto& body : state.bodies) meshes.push_back(&body.mesh);
  return meshes;
}

/// Whether glass and tools stand still for the whole stage.
bool stands_still(const Scene& scene, const Stage& stage) {
  return !scene.has_flow() && std::all_of(stage.tools.begin(), stage.tools.end(), [](const auto& tool) {
    return std::holds_alternative<std::monostate>(tool.motion);
  });
}

/// Steps after which the integrator of a standing stage starts anew, for a checkpoint to be possible: some seconds of
/// work.
constexpr long most_inner_steps = 300;

/// Whether the integrator is to start anew: after steps that depend on the case alone, never on the clock.
bool is_spent(const Scene& scene, const Workspace::Standing& standing) {
  const auto& steps = scene.output.checkpoint_steps;
  return standing.inner_steps >= most_inner_steps || (steps && standing.steps >= *steps);
}

HeatOutcome advance_standing(const Scene& scene, State& state, const std::vector<core::InterfacePoint>& interface,
                             double dt, Workspace& workspace) {
  auto& standing = workspace.standing;
  if (!standing || standing->stage != state.stage || standing->spent) {
    standing = std::make_unique<Workspace::Standing>();
    standing->stage = state.stage;
    standing->start = state.time;
    for (const auto& body : state.bodies) standing->meshes.push_back(body.mesh);
    Meshes meshes;
    for (const auto& mesh : standing->meshes) meshes.push_back(&mesh);
    auto problem = make_problem(scene, state, meshes, interface, workspace.table_holds);
    if (limits_radiation(scene)) {
      standing->thickness = {
          remesh::wall_thickness(standing->meshes[0], symmetry_pieces(scene.glass, standing->meshes[0]))};
      problem.bodies[0].wall_thickness = &standing->thickness[0];
    }
    thermal::IdaOptions options;
    options.tolerance = scene.accuracy.temperature_tolerance;
    standing->integrator.emplace(std::move(problem), temperatures(state), options);
  }
  auto outcome = standing->integrator->advance_to(state.time + dt - standing->start);
  if (!outcome.converged) {
    standing.reset();
    return {false, outcome.reason};
  }
  standing->inner_steps += outcome.steps;
  ++standing->steps;
  standing->spent = is_spent(scene, *standing);
  take_temperatures(state, std::move(outcome.temperature));
  book(outcome.ledger, state);
  return {true, "", static_cast<int>(outcome.steps)};
}

}  // namespace

HeatOutcome advance_heat(const Scene& scene, State& state, const std::vector<core::InterfacePoint>& interface,
                         const std::vector<double>& dissipation, double dt, Workspace& workspace) {
  HeatOutcome result;
  if (stands_still(scene, scene.stages[state.stage])) {
    result = advance_standing(scene, state, interface, dt, workspace);
  } else {
    workspace.standing.reset();
    const auto meshes = meshes_of(state);
    const core::Mesh mass = mass_mesh(state);
    auto problem = make_problem(scene, state, meshes, interface, workspace.table_holds);
    problem.bodies[0].mass_mesh = &mass;
    if (!dissipation.empty()) problem.bodies[0].source = &dissipation;
    Eigen::VectorXd thickness;
    if (limits_radiation(scene)) {
      thickness = remesh::wall_thickness(*meshes[0], symmetry_pieces(scene.glass, *meshes[0]));
      problem.bodies[0].wall_thickness = &thickness;
    }
    thermal::StepOptions options;
    options.tolerance = scene.accuracy.temperature_tolerance;
    options.newton_tolerance = newton_share * options.tolerance;
    options.first_substep = state.heat_substep;
    workspace.heat.couplings = couplings_of(state);
    auto outcome = thermal::advance(problem, temperatures(state), dt, options, workspace.heat);
    if (!outcome.converged) return {false, outcome.reason};
    take_couplings(state, workspace.heat.couplings);
    take_temperatures(state, std::move(outcome.temperature));
    book(outcome.ledger, state);
    state.heat_substep = outcome.next_substep;
    result = {true, "", static_cast<int>(outcome.substeps)};
  }
  if (!result.converged) return result;
  note_hottest_surfaces(scene, state);
  note_overshoot(scene, state);
  return result;
}

}  // namespace parison::forming
