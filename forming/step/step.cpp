// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/step.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/process/clock.hpp"
#include "forming/state/interpolate.hpp"
#include "forming/step/balance/volume_conservation.hpp"
#include "forming/step/balance/work.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/edge_correction.hpp"
#include "forming/step/contact/first_touch.hpp"
#include "forming/step/cooling/cooling_step.hpp"
#include "forming/step/flow/flow_step.hpp"
#include "forming/step/flow/predictor.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "forming/step/heat/surface_temperature.hpp"
#include "forming/step/heat/thermal_interface.hpp"
#include "forming/step/step_control.hpp"
#include "forming/step/step_parts.hpp"
#include "forming/step/step_start.hpp"
#include "remesh/surface/outline.hpp"

namespace parison::forming {

namespace {

/// Velocities of tools that move by position where nothing flows.
void store_tool_velocities(const Scene& scene, double dt, State& state) {
  const auto motions = tool_motions(scene, state, dt);
  for (const auto& tool : scene.stages[state.stage].tools)
    state.tools[tool.tool].velocity = motions[tool.tool].velocity;
}

/// Velocities of the step: by the flow, or as prescribed for the tools.
bool find_velocities(const StepStart& start, MidpointPredictor& predictor, Workspace& workspace, StepResult& result) {
  if (!start.scene.has_flow()) {
    store_tool_velocities(start.scene, start.dt, result.state);
    return true;
  }
  const core::ScopedTimer timer(result.report.seconds["flow"]);
  return iterate_until_converged(start, predictor, workspace, result);
}

/// Whether no edge of the glass has come deeper into a tool than its correction leaves one that it can move: where a
/// cell has become too flat to let its edge out, shorter steps give it a new mesh before.
bool has_no_edge_in_tools(const StepStart& start, StepResult& result) {
  if (start.dt <= min_step_ratio * start.scene.accuracy.initial_step) return true;
  const double depth = result.edge_depth = edge_depth_gained(start.scene, start.state, result.state);
  if (depth > 0) result.reason = fmt::format("the step moves an edge of the glass {:.2g} um into a tool", 1e6 * depth);
  return depth == 0;
}

/// Whether the step has moved no glass into glass, but as little as the next mesh gives to the rest of the surface.
bool has_no_glass_in_glass(const StepStart& start, StepResult& result) {
  constexpr double allowed = 1e-3;  // of the volume
  const core::Geometry geometry = start.scene.geometry;
  const core::Mesh& mesh = result.state.glass.mesh;
  if (start.dt <= min_step_ratio * start.scene.accuracy.initial_step || !remesh::crosses_itself(mesh)) return true;
  const double gained =
      (remesh::overlap_volume(geometry, mesh) - remesh::overlap_volume(geometry, start.state.glass.mesh)) /
      start.state.glass.initial_volume;
  if (gained > allowed) result.reason = fmt::format("the step moves {:.2g} % of the glass into glass", 100 * gained);
  return gained <= allowed;
}

/// Whether the temperatures in the middle of the next step can be predicted: not in a stage's first, which does not
/// know how they change.
bool predicts_temperature(const Scene& scene, const State& state) {
  return !scene.has_heat() || state.last_step > 0 || !state.glass.temperature_rate.isZero(0);
}

/// Flow, half the motion, heat, the other half.
bool pass_once(const StepStart& start, MidpointPredictor& predictor, Workspace& workspace, StepResult& result) {
  const Scene& scene = start.scene;
  const double dt = start.dt;
  if (!find_velocities(start, predictor, workspace, result)) return false;
  move_bodies(scene, 0.5 * dt, result);
  if (scene.has_flow() && !has_no_inverted_cells(scene, result)) return false;
  if (!step_heat(scene, dt, workspace, result)) return false;
  move_bodies(scene, 0.5 * dt, result);
  return !scene.has_flow() || (has_no_inverted_cells(scene, result) && has_no_glass_in_glass(start, result));
}

/// The middle of a step, and its expansion, before it is tried.
MidpointPredictor first_prediction(const Scene& scene, const State& state, double dt) {
  if (!scene.has_flow()) return {};
  MidpointPredictor predictor{
      carried_velocity(scene, state, dt), predicted_temperature(scene, state, 0.5 * dt), state.moves_smoothly, {}};
  if (follows_density(scene))
    predictor.expansion = expansion_until(scene, state, predicted_temperature(scene, state, dt), dt);
  return predictor;
}

/// How often flow and heat are passed through in a step: again where the flow had no temperature to begin with.
int passes(const Scene& scene, const State& state) {
  return scene.has_flow() && !predicts_temperature(scene, state) ? 2 : 1;
}

/// Goes back to the step's start with a prediction from what the pass before has found.
void begin_again(const StepStart& start, MidpointPredictor& predictor, StepResult& result) {
  const State& state = start.state;
  predictor.expansion = expansion_until(start.scene, state, result.state.glass.temperature, start.dt);
  predictor.temperature = 0.5 * (state.glass.temperature + result.state.glass.temperature);
  auto active = std::move(result.state.glass.active_contacts);
  result.state = state;
  result.state.glass.active_contacts = std::move(active);
  result.report.off_axis = 0;
}

/// Takes edges out of tools and gives the glass its volume or mass; false where an edge stays too deep.
bool correct_glass(const StepStart& start, StepResult& result) {
  if (!start.scene.has_flow()) return true;
  update_rates(start.state, start.dt, result.state);
  correct_edges(start.scene, result.state);
  if (!has_no_edge_in_tools(start, result)) return false;
  conserve_mass(start.scene, start.state, result.flow.tool_dilatation_mode, start.dt, result.state);
  return true;
}

/// Whether a node touches a tool again that it left in the step before, or the other way round.
bool flickers(const GlassFields& before, const GlassFields& after) {
  for (std::size_t n = 0; n < after.contact_tool.size(); ++n) {
    const bool first = before.previous_contact_tool[n] >= 0, then = before.contact_tool[n] >= 0;
    if (first != then && (after.contact_tool[n] >= 0) == first) return true;
  }
  return false;
}

/// Notes the work of a step by temperatures of its middle that its heat did not bear out.
void note_unforeseen(const StepStart& start, StepResult& result) {
  const auto &before = start.state, &after = result.state;
  const double work =
      unforeseen_work(start.scene.glass.flow->viscosity, before.glass.mesh, result.dissipation, result.flow_temperature,
                      before.glass.temperature, result.at_heat.glass.temperature, start.dt);
  const double measure = measure_of_error(start.scene, before, before.totals.work, after.totals.work);
  result.report.flickers = flickers(before.glass, after.glass);
  result.report.unforeseen_work = work;
  result.report.unforeseen_error = measure > 0 ? work / measure : 0;
}

/// What the step control needs of a step, in the report and for the steps to come.
void report_step(const StepStart& start, const Workspace& workspace, StepResult& result) {
  StepReport& report = result.report;
  report.dt = start.dt;
  report.clamped_lookups = workspace.clamped_lookups;
  if (start.scene.has_flow() && start.scene.has_heat()) note_unforeseen(start, result);
  // Where nothing moves the heat integrator alone chooses the steps.
  if (start.scene.has_heat() && !start.scene.has_flow() && !workspace.static_stage)
    report.temperature_change = surface_temperature_change(start.scene, start.state, result.state, report.interface);
  result.state.last_landed = report.landed_length;
  result.state.last_work_error = report.work_error;
}

}  // namespace

StepResult coupled_step(const Scene& scene, const State& state, double dt, Workspace& workspace) {
  workspace.heat.factored_step = 0;  // its factor comes from earlier steps
  workspace.clamped_lookups = 0;
  const StepStart start = step_start(scene, state, dt);
  if (scene.stages[state.stage].cools) return cooling_step(start, workspace);
  StepResult result;
  result.state = state;
  MidpointPredictor predictor = first_prediction(scene, state, dt);
  for (int pass = 0; pass < passes(scene, state); ++pass) {
    if (pass > 0) begin_again(start, predictor, result);
    if (!pass_once(start, predictor, workspace, result)) return result;
  }
  if (!correct_glass(start, result)) return result;
  finish(start, result.state);
  report_step(start, workspace, result);
  result.converged = true;
  return result;
}

}  // namespace parison::forming
