// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/flow/flow_solve.hpp"

#include <algorithm>
#include <optional>

#include "forming/step/balance/volume_conservation.hpp"
#include "forming/step/contact/carrier.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/contact_prediction.hpp"

namespace parison::forming {

namespace {

std::vector<flow::BoundaryCondition> boundary_conditions(const Scene& scene, const State& state, double dt) {
  std::vector<flow::BoundaryCondition> conditions;
  const auto& pressure = scene.stages[state.stage].pressure;
  for (const auto& [name, kind] : state.glass.mesh.boundaries()) {
    flow::BoundaryCondition condition;
    if (kind == BoundaryKind::symmetry) condition.kind = flow::BoundaryCondition::Kind::symmetry;
    if (kind == BoundaryKind::fixed) condition.kind = flow::BoundaryCondition::Kind::fixed;
    if (const auto found = pressure.find(name); found != pressure.end())
      condition.pressure = found->second.mean(state.stage_time, state.stage_time + dt);
    conditions.push_back(condition);
  }
  return conditions;
}

/// The expansion rate with which the flow conserves mass and not volume, as far as its velocity can be predicted.
std::vector<double> conserving_rate(const StepStart& start, const core::Mesh& middle,
                                    const MidpointPredictor& predictor) {
  std::vector<double> rate = predictor.expansion.rate;
  if (rate.empty() || !predictor.trusted) return rate;
  const auto mean = mean_divergence(start.scene, start.state, middle, predictor.velocity, predictor.expansion);
  for (double& here : rate) here += mean.of_volume - mean.of_mass;
  return rate;
}

}  // namespace

flow::Problem loaded_problem(const StepStart& start, const core::Mesh& middle, const Eigen::VectorXd& velocity,
                             const std::vector<flow::ContactCandidate>& bounds) {
  const Scene& scene = start.scene;
  const State& state = start.state;
  flow::Problem problem{};
  problem.mesh = &middle;
  problem.geometry = scene.geometry;
  problem.material = &*scene.glass.flow;
  problem.frozen = start.frozen;
  problem.gravity = scene.stages[state.stage].gravity;
  problem.boundary_conditions = boundary_conditions(scene, state, start.dt);
  problem.tools = tool_motions(scene, state, start.dt);
  problem.candidates = contact_candidates(scene, state, velocity, start.dt);
  keep_bounds(bounds, problem.candidates);
  keep_bounds(corner_bounds(scene, state), problem.candidates);
  problem.air = start.air;
  return problem;
}

FlowPass solve_flow(const StepStart& start, const ActiveContacts& active, const MidpointPredictor& predictor,
                    Workspace& workspace) {
  const Scene& scene = start.scene;
  const State& state = start.state;
  const double dt = start.dt;
  const core::Mesh middle = midpoint_mesh(scene, state, predictor, dt);
  flow::Problem problem = loaded_problem(start, middle, predictor.velocity, predictor.bounds);
  problem.temperature = &predictor.temperature;
  problem.dilatation_rate = prescribed_dilatation_rate(
      scene, state, middle, predictor.trusted ? &predictor.velocity : nullptr, dt, predictor.expansion);
  problem.expansion_rate = conserving_rate(start, middle, predictor);
  problem.with_dilatation_mode = true;
  auto warm = likely_contacts(state, active, problem, predictor.velocity);
  const bool floating = floats(problem);
  // What nothing drives follows the balance: trapped air may carry the glass.
  const auto carrier_force = floating ? std::nullopt : std::optional<double>(0.0);
  const bool carried = (problem.air || floating) && add_carrier(problem, warm, carrier_force);
  if (!workspace.flow) workspace.flow.emplace(middle);
  auto equilibrium = workspace.flow->find_equilibrium(problem, warm);
  correct_volume(scene, state, dt, predictor.expansion.end_temperature, equilibrium);
  auto solution = flow::evaluate(problem, std::move(equilibrium));
  if (carried) remove_carrier(problem, solution);
  if (floating && solution.converged) keep_centre_of_mass(problem, solution);
  return {std::move(problem.candidates), std::move(solution)};
}

void store_flow(const Scene& scene, const FlowPass& pass, double dt, State& state) {
  const auto& [candidates, solution] = pass;
  state.glass.velocity = solution.velocity;
  keep_on_symmetry(state.glass.mesh, state.glass.velocity);
  if (solution.dilatation_mode.size() > 0) state.glass.dilatation_mode = solution.dilatation_mode;
  state.last_step = dt;
  std::fill(state.glass.contact_tool.begin(), state.glass.contact_tool.end(), -1);
  for (std::size_t i = candidates.size(); i-- > 0;)
    if (solution.active[i]) state.glass.contact_tool[candidates[i].node] = candidates[i].tool;
  for (const auto& candidate : candidates)  // glass that has come off a tool that grips is still held by it
    if (Index& tool = state.glass.contact_tool[candidate.node]; candidate.tied && tool < 0) tool = candidate.tool;
  state.glass.active_contacts = {};
  for (std::size_t i = 0; i < candidates.size(); ++i)
    if (solution.active[i]) {
      state.glass.active_contacts.node.push_back(candidates[i].node);
      state.glass.active_contacts.tool.push_back(candidates[i].tool);
      state.glass.active_contacts.normal.push_back(candidates[i].normal);
    }
  state.glass.contact_pressure = solution.contact_pressure;
  for (const auto& tool : scene.stages[state.stage].tools) {
    auto& body = state.tools[tool.tool];
    body.velocity = solution.tool_velocity[tool.tool];
    body.force = solution.tool_force[tool.tool];
  }
}

}  // namespace parison::forming
