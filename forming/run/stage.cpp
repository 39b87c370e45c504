// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/stage.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/tolerances.hpp"
#include "forming/remeshing/named_boundary.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/report/container/container_report.hpp"
#include "forming/report/process/mould_filling.hpp"
#include "forming/run/room_in_tool.hpp"
#include "forming/run/step_loop.hpp"
#include "forming/run/warnings.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/carrier.hpp"
#include "forming/step/contact/penetration.hpp"
#include "forming/step/cooling/cooling_step.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {

std::string stage_precondition_failure(const Scene& scene, const State& state) {
  const double size = core::size(scene.glass.profile);
  for (const auto& place : scene.stages[state.stage].tools) {
    const auto* position = std::get_if<PositionMotion>(&place.motion);
    const double now = state.tools[place.tool].offset;
    if (position && std::abs(position->offset(0) - now) > core::tolerance::motion_start * size)
      return fmt::format("tool {} is at {:.4g} mm, but its motion starts at {:.4g} mm", scene.tools[place.tool].name,
                         1e3 * now, 1e3 * position->offset(0));
  }
  Penetration max_penetration{};
  for (const Penetration& inside : penetrations(scene, state, 0))
    if (inside.depth > max_penetration.depth) max_penetration = inside;
  if (max_penetration.depth <= core::tolerance::stage_overlap * size) return unsupported_glass(scene, state);
  const Point& x = state.glass.mesh.nodes[max_penetration.node];
  const std::string& tool = scene.tools[max_penetration.tool].name;
  const ExcessSize excess = excess_size(scene, state, max_penetration.tool);
  return fmt::format(
      "active tool {} overlaps the glass{} at ({:.4g}, {:.4g}) mm; the glass does not fit between "
      "the tools of the stage. Where the blank as drawn is longer or wider than this tool (`parison check` compares "
      "them), one of the drawings has to change; a parison that has sagged too far needs less time or cooler glass "
      "before; a tool that closes on it needs a position clear of the glass and motion.{} = {{ offset = [...] }}",
      tool,
      excess.length > max_penetration.depth ? ", which is " + describe(excess, "its cavity") + ","
                                            : fmt::format(" by {:.3g} mm", 1e3 * max_penetration.depth),
      1e3 * x[0], 1e3 * x[1], tool);
}

std::string first_stage_failure(const Scene& scene) {
  return stage_precondition_failure(scene, start_stage(scene, initial_state(scene), 0));
}

namespace {

/// Whether the case says how a body is meshed.
bool has_own_mesh(const Body& body) {
  return body.mesh.size || body.mesh.contact_size || body.mesh.growth || body.mesh.mapped;
}

/// New meshes of the glass at the start of a stage. Its first mesh does not know the temperatures that the glass starts
/// with: where they vary, meshes follow each other until they resolve them, and each takes them from the case again.
bool remesh_at_start(RunInProgress& run, Index stage) {
  const Eigen::VectorXd& temperature = run.outcome.state.glass.temperature;
  const bool varies = stage == 0 && temperature.size() > 0 && temperature.maxCoeff() > temperature.minCoeff();
  constexpr int meshes_where_varying = 3;
  for (int mesh = 0; mesh < (varies ? meshes_where_varying : 1); ++mesh) {
    if (!remesh_glass(run, RemeshReason::stage_start)) return false;
    if (varies) set_start_temperature(run.scene, run.outcome.state);
  }
  return true;
}

/// Lets the glass cool from here on, and notes the container as it is.
void start_cooling(RunInProgress& run) {
  CoolingSeen& seen = run.outcome.facts.diagnostics.cooling;
  if (const auto container = container_report(run.scene, run.outcome.state, true)) {
    seen.capacity = container->capacity.value_or(0);
    seen.height = container->size.height;
    seen.diameter = container->size.diameter;
  }
  seen.volume = core::volume(run.outcome.state.glass.mesh, run.scene.geometry);
  begin_cooling(run.outcome.state);
}

}  // namespace

double first_step(const Scene& scene, Index stage) {
  constexpr double share = 1e-3;  // of its duration
  const double usual = scene.accuracy.initial_step;
  return scene.stages[stage].cools ? std::max(usual, share * scene.stages[stage].duration) : usual;
}

std::string after_press(const RunFacts& facts, const std::string& failure) {
  if (failure.empty() || facts.unfilled.empty()) return failure;
  return fmt::format("{}; in this stage {}", facts.unfilled, failure);
}

bool begin_stage(RunInProgress& run, Index stage) {
  State& state = run.outcome.state;
  const std::string misplaced = misplaced_boundary(run.scene, state, stage);
  state = start_stage(run.scene, state, stage);
  state.next_step = first_step(run.scene, stage);
  state.next_limit = static_cast<Index>(StepLimit::initial);
  run.workspace.static_stage.reset();
  const bool good = !ends_by(
      run,
      after_press(run.outcome.facts, misplaced.empty() ? stage_precondition_failure(run.scene, state) : misplaced));
  notify(run, &RunObserver::stage_begins);
  if (stage == 0) notify(run, &RunObserver::fields_due, state);
  const bool cools = run.scene.stages[stage].cools, goes_on = cools && remembers(state);
  const bool keeps_mesh = !run.scene.has_flow() || goes_on || (stage == 0 && has_own_mesh(run.scene.glass));
  if (!good || !(keeps_mesh || remesh_at_start(run, stage))) return false;
  if (cools && !goes_on) start_cooling(run);
  if (stage == 0) add_warnings(start_field_warnings(run.scene, state), run.outcome.facts);
  return true;
}

void update_motion(const Scene& scene, State& state) {
  const Stage& stage = scene.stages[state.stage];
  for (const StageTool& tool : stage.tools)
    if (tool.is_driven() && stage.end_speed && std::abs(state.tools[tool.tool].velocity) > *stage.end_speed)
      state.has_moved = true;
}

namespace {

/// Why the present stage has ended, in the words of the results.
const char* end_reason(const RunInProgress& run, bool good) {
  if (run.outcome.facts.stopped) return "stop";
  if (!good) return "failure";
  return name_of(stage_end(run.scene, run.outcome.state));
}

/// Notes what driven tools have not filled, or else which of them still move.
void look_at_driven_tools(RunInProgress& run) {
  const State& state = run.outcome.state;
  RunFacts& facts = run.outcome.facts;
  const auto unfilled = unfilled_cavity(run.scene, state);
  if (unfilled) facts.unfilled = *unfilled;
  const bool told = unfilled && !unfilled->empty();
  if (!told && stage_end(run.scene, state) == StageEnd::duration)
    add_warnings(moving_tool_warnings(run.scene, state), facts);
}

}  // namespace

void end_stage(RunInProgress& run, bool good) {
  const State& state = run.outcome.state;
  RunFacts& facts = run.outcome.facts;
  const char* reason = end_reason(run, good);
  facts.stages.push_back(
      {run.scene.stages[state.stage].name, state.stage_start, state.time, reason, state.totals.work});
  if (good && run.scene.stages[state.stage].blows()) facts.filling = mould_filling(run.scene, state);
  if (good && !facts.stopped) look_at_driven_tools(run);
}

}  // namespace parison::forming
