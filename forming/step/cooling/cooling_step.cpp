// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/cooling/cooling_step.hpp"

#include <algorithm>
#include <utility>

#include "core/process/clock.hpp"
#include "forming/cooling/glass_memory.hpp"
#include "forming/cooling/nodal_values.hpp"
#include "forming/step/contact/carrier.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/contact_prediction.hpp"
#include "forming/step/flow/flow_solve.hpp"
#include "forming/step/flow/flow_step.hpp"
#include "forming/step/step_parts.hpp"

namespace parison::forming {

namespace {

cooling::GlassMemory memory_of(const GlassState& glass) {
  return {glass.branch_stress, glass.fictive_temperature, glass.mean_pressure};
}

void store(cooling::GlassMemory memory, GlassState& glass) {
  glass.branch_stress = std::move(memory.stress);
  glass.fictive_temperature = std::move(memory.fictive);
  glass.mean_pressure = std::move(memory.pressure);
}

/// The largest change of temperature, K, with its weight. `change`: by node, K.
double weighted_change(const cooling::GlassLaw& law, const core::Mesh& mesh, const cooling::MemoryStep& step,
                       const Eigen::VectorXd& change) {
  double largest = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c) {
    double of_cell = 0;
    for (const Index node : mesh.cells()[c]) of_cell = std::max(of_cell, std::abs(change[node]));
    const auto* points = &step.relaxation[c * core::cell_points];
    largest = std::max(largest, of_cell * cooling::weight_of_change(law, points, core::cell_points));
  }
  return largest;
}

/// The equilibrium on the mesh in the middle of the step; `velocity` is the one expected, m/s.
FlowPass solve(const StepStart& start, const core::Mesh& middle, const Eigen::VectorXd& velocity,
               const Eigen::VectorXd& temperature, const cooling::MemoryStep& step, Workspace& workspace) {
  flow::Problem problem = loaded_problem(start, middle, velocity, {});
  flow::Material material = *problem.material;
  material.shear_thinning.reset();
  problem.material = &material;
  problem.temperature = &temperature;
  problem.memory = &step.flow;
  auto warm = likely_contacts(start.state, start.state.glass.active_contacts, problem, velocity);
  const bool floating = floats(problem);
  const bool carried = floating && add_carrier(problem, warm, std::nullopt);
  if (!workspace.flow) workspace.flow.emplace(middle);
  auto solution = workspace.flow->solve(problem, warm);
  if (carried) remove_carrier(problem, solution);
  if (floating && solution.converged) keep_centre_of_mass(problem, solution);
  return {std::move(problem.candidates), std::move(solution)};
}

void report_step(const StepStart& start, const cooling::MemoryStep& step, const flow::Solution& solution,
                 StepResult& result) {
  StepReport& report = result.report;
  const Eigen::VectorXd change = result.state.glass.temperature - start.state.glass.temperature;
  report.dt = start.dt;
  report.flow_solves = report.coupling_iterations = 1;
  report.flow_factorisations = solution.factorisations;
  report.contact_changes = solution.contact_changes;
  report.locked_contacts = solution.locked;
  report.contacts = static_cast<Index>(std::count(solution.active.begin(), solution.active.end(), true));
  report.strain = start.dt * solution.high_rate;
  report.temperature_change = weighted_change(*start.scene.glass.annealing, start.state.glass.mesh, step, change);
}

}  // namespace

void begin_cooling(State& state) {
  store(cooling::at_rest(state.glass.mesh, state.glass.temperature), state.glass);
}

StepResult cooling_step(const StepStart& start, Workspace& workspace) {
  const Scene& scene = start.scene;
  const State& state = start.state;
  const double dt = start.dt;
  StepResult result;
  result.state = state;
  State& after = result.state;
  const Eigen::VectorXd expected = predicted_velocity(state, 0.5 * dt);
  after.glass.velocity = expected;
  move_bodies(scene, 0.5 * dt, result);
  if (!has_no_inverted_cells(scene, result) || !step_heat(scene, dt, workspace, result)) return result;
  const core::ScopedTimer timer(result.report.seconds["flow"]);
  const core::Mesh middle = after.glass.mesh;
  const cooling::GlassMemory memory = memory_of(state.glass);
  const cooling::MemoryStep step =
      cooling::start_step(*scene.glass.annealing, middle, memory, state.glass.temperature, after.glass.temperature, dt);
  FlowPass pass = solve(start, middle, expected, after.glass.temperature, step, workspace);
  result.reason = pass.solution.reason;
  if (!pass.solution.converged) return result;
  store_flow(scene, pass, dt, after);
  const auto strains = flow::strains(middle, flow::cell_geometry(middle, scene.geometry), dt * pass.solution.velocity);
  store(cooling::end_step(step, memory, middle, strains, pass.solution.pressure), after.glass);
  after.glass.mesh.nodes = state.glass.mesh.nodes;
  move_glass_probes(scene, state.glass.mesh, after.glass.velocity, dt, after);
  for (Index n = 0; n < middle.node_count(); ++n)
    after.glass.mesh.nodes[n] += dt * flow::node_velocity(after.glass.velocity, n);
  keep_beside_axis(scene.geometry, after.glass.mesh);
  if (!has_no_inverted_cells(scene, result)) return result;
  update_rates(state, dt, after);
  finish(start, after);
  report_step(start, step, pass.solution, result);
  result.flow = std::move(pass.solution);
  result.flow_temperature = after.glass.temperature;
  result.report.clamped_lookups = workspace.clamped_lookups;
  result.converged = true;
  return result;
}

Eigen::VectorXd nodal_stress(const GlassState& glass, bool only_surface) {
  if (glass.branch_stress.size() == 0) return {};
  const auto points = cooling::stress_at_points(glass.mesh, glass.branch_stress, glass.mean_pressure);
  constexpr Index components = 4;
  const Eigen::Map<const Eigen::VectorXd> values(points.front().data(), components * Index(points.size()));
  std::vector<bool> vertices;
  if (only_surface) {
    vertices.resize(glass.mesh.vertex_count());
    for (const auto& edge : glass.mesh.boundary_edges()) vertices[edge.nodes[0]] = vertices[edge.nodes[1]] = true;
  }
  return cooling::to_nodes(glass.mesh, values, components, vertices);
}

Eigen::VectorXd nodal_fictive_temperature(const Scene& scene, const GlassState& glass) {
  if (glass.fictive_temperature.size() == 0) return {};
  return cooling::to_nodes(glass.mesh, cooling::fictive_at_points(*scene.glass.annealing, glass.fictive_temperature),
                           1);
}

}  // namespace parison::forming
