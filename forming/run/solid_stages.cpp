// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/solid_stages.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/process/run_error.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/report/cooling/cold_container.hpp"
#include "forming/report/wall/solid_wall.hpp"
#include "forming/run/fast_glass.hpp"
#include "forming/run/room_in_tool.hpp"
#include "forming/run/stage.hpp"
#include "forming/run/stall.hpp"
#include "forming/solid/hand_over.hpp"
#include "forming/solid/solid_end.hpp"
#include "forming/solid/solid_memory.hpp"
#include "forming/solid/solid_step.hpp"
#include "forming/solid/straighten.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {

namespace {

/// Steps from one possible checkpoint to the next within a stage.
constexpr Index steps_to_checkpoint = 8;

/// Where glass is larger than a tool that a stage brings, as a sentence; empty where it is so by no more than bearable,
/// m.
std::string larger_than_tool(const RunInProgress& run, const SolidState& solid, Index stage, double bearable) {
  const SolidOverlap overlap = deepest_overlap(run.scene, run.outcome.state, solid, stage, SolidTools::coming);
  if (overlap.depth <= bearable) return "";
  const std::string& tool = run.scene.tools[overlap.tool].name;
  const std::string start =
      fmt::format("the glass does not fit into \"{}\" of stage {}: it ", tool, run.scene.stages[stage].name);
  if (overlap.is_end)
    return start +
           fmt::format("hangs {:.2f} mm too long, to z = {:.1f} mm; less time or colder glass before, or a longer tool",
                       1e3 * overlap.depth, 1e3 * overlap.at[2]);
  return start + fmt::format(
                     "is {:.2f} mm too wide at z = {:.1f} mm, {:.0f} deg from the plane y = 0; a narrower blank, "
                     "a wider mould there, or less time in which the parison sags",
                     1e3 * overlap.depth, 1e3 * overlap.at[2], std::atan2(overlap.at[1], overlap.at[0]) * 180 / M_PI);
}

/// Why the present stage cannot begin with the places of glass and tools; empty where it can.
std::string cannot_begin(const RunInProgress& run, const SolidState& solid) {
  constexpr double bearable = 2e-4;  // m: cells of the glass are chords of the curve that they were turned from
  return larger_than_tool(run, solid, run.outcome.state.stage, bearable);
}

/// Whether glass that no pressure moves has outgrown a tool of the next stage: it only gets longer until it falls.
std::string outgrown(const RunInProgress& run, const SolidState& solid) {
  const Scene& scene = run.scene;
  const Index stage = run.outcome.state.stage;
  if (stage + 1 >= static_cast<Index>(scene.stages.size()) || !scene.stages[stage].pressure.empty() ||
      scene.stages[stage + 1].cools)
    return "";
  return larger_than_tool(run, solid, stage + 1, outgrown_from * core::size(scene.glass.profile));
}

/// The step up to the next output or the end of the stage, s, at most `proposed`.
double clipped(const Scene& scene, const State& clock, double proposed) {
  const double end = longest_stage_time(scene, clock) - clock.stage_time;
  const auto outputs = outputs_due(scene, clock.stage, clock.time, clock.time + proposed);
  const double until = outputs.empty() ? end : std::min(end, outputs.front() - clock.time);
  if (proposed >= until) return until;
  return proposed > 0.5 * until ? 0.5 * until : proposed;  // no very short step is left
}

Point in_plane(const core::Vector3& at) {
  return {std::hypot(at[0], at[1]), at[2]};
}

/// The node of the contact surface that is hottest; -1 without one.
Index hottest_contact_node(const SolidTool& tool) {
  Index hottest = -1;
  for (const core::QuadFace& face : tool.mesh.faces)
    if (tool.mesh.boundaries[static_cast<std::size_t>(face.boundary_id)].kind == core::BoundaryKind::contact)
      for (const Index node : face.nodes)
        if (hottest < 0 || tool.temperature[node] > tool.temperature[hottest]) hottest = node;
  return hottest;
}

/// Takes an accepted step into account, which ended at the time of `clock`; places are those in a plane through the
/// axis.
void follow_extremes(const Scene& scene, const State& clock, const SolidState& solid, Extremes& extremes) {
  const Flags& flags = scene.output.flags;
  for (std::size_t t = 0; t < solid.tools.size(); ++t) {
    const SolidTool& tool = solid.tools[t];
    const Index node = hottest_contact_node(tool);
    if (node < 0) continue;
    Extreme& extreme = extremes.tools[static_cast<std::size_t>(tool.tool)];
    const double temperature = tool.temperature[node];
    if (!(temperature <= extreme.temperature))
      extreme.set(temperature, clock.time,
                  in_plane(tool.mesh.nodes[node]) + clock.tools[tool.tool].offset * core::axis_direction());
    const bool touched = std::any_of(
        solid.glass.contact.begin(), solid.glass.contact.end(),
        [&](const flow::SolidContact& point) { return point.touches && point.tool == static_cast<Index>(t); });
    if (touched && temperature > flags.tool_surface_above) extreme.add_beyond(clock.time, solid.last_step);
  }
  Eigen::Index coldest = 0;
  const double temperature = solid.glass.temperature.minCoeff(&coldest);
  if (!(temperature >= extremes.glass.temperature))
    extremes.glass.set(temperature, clock.time, in_plane(solid.glass.mesh.nodes[coldest]));
  if (flags.glass_below && temperature < *flags.glass_below) extremes.glass.add_beyond(clock.time, solid.last_step);
}

/// What the control of steps asks of one of glass that cools.
StepReport report_of(double dt, const SolidStepOutcome& outcome) {
  StepReport report;
  report.dt = dt;
  report.strain = outcome.flow.strain;
  report.temperature_change = outcome.temperature_change;
  return report;
}

/// Tries a step of length dt, s, and shorter ones up to where a condition ends the stage; `dt` is then that of the
/// last.
SolidStepOutcome step_up_to_end(RunInProgress& run, double& dt, SolidState& solid, SolidWorkspace& workspace) {
  const Scene& scene = run.scene;
  const State& clock = run.outcome.state;
  const Stage& stage = scene.stages[clock.stage];
  if (stage.ends.empty() && !remembers(solid)) return step_solid(scene, clock, dt, solid, workspace);
  constexpr int most_repeats = 4;
  SolidState before = solid;
  for (int repeats = 0;; ++repeats) {
    SolidStepOutcome outcome = step_solid(scene, clock, dt, solid, workspace);
    if (outcome.accepted && remembers(solid) && rejected_by_error_control(scene, report_of(dt, outcome))) {
      solid = before;
      outcome.accepted = false;
      outcome.reason = "the temperature of the glass changes too fast";
    }
    if (!outcome.accepted || repeats == most_repeats) return outcome;
    const double share = share_until_end(stage, end_measure(scene, clock, clock.stage_time, before),
                                         end_measure(scene, clock, clock.stage_time + dt, solid));
    const double until = shortened_to_end(dt, (1 - share) * dt, solid.next_step);
    if (until == dt) return outcome;
    dt = until;
    ++before.totals.rejected;
    solid = before;
  }
}

/// The length of the next step, s, after one of length dt that might have had the length `allowed`.
double next_step(const Scene& scene, const State& clock, const SolidState& solid, double dt, double allowed,
                 const SolidStepOutcome& outcome) {
  if (remembers(solid)) return propose_step(scene, clock, report_of(dt, outcome), allowed).dt;
  return propose_solid_step(scene, clock, solid, allowed);
}

/// A step that is accepted; false when the shortest is not, and the facts say why.
bool step_once(RunInProgress& run, SolidState& solid, SolidWorkspace& workspace) {
  State& clock = run.outcome.state;
  const bool cools = remembers(solid);  // on a mesh that it keeps
  if (!cools) straighten(*run.scene.glass.flow, *run.scene.glass.thermal, solid);
  double dt = clipped(run.scene, clock, solid.next_step);
  bool rejected = false;
  SolidStepOutcome outcome;
  for (;;) {
    outcome = step_up_to_end(run, dt, solid, workspace);
    if (outcome.accepted) break;
    ++solid.totals.rejected;
    constexpr StraightenLimits before_shorter{0.3, 0.4};
    const bool first = !std::exchange(rejected, true);
    if (first && !cools && straighten(*run.scene.glass.flow, *run.scene.glass.thermal, solid, before_shorter)) continue;
    dt *= shorten;
    if (dt < run.scene.accuracy.min_step) {
      std::string& reason = run.outcome.facts.reason;
      reason = after_press(run.outcome.facts, fmt::format("{}, also in steps of {:g} s, numerics.min_step",
                                                          outcome.reason, run.scene.accuracy.min_step));
      if (const auto fast = fast_glass(solid))
        reason = fmt::format("{} (numerics: {})",
                             run.scene.stages[clock.stage].pressure.empty() ? falls(*fast) : bursts(*fast), reason);
      return false;
    }
  }
  clock.time += dt;
  clock.stage_time += dt;
  ++clock.totals.steps;
  for (const StageTool& tool : run.scene.stages[clock.stage].tools)
    clock.tools[tool.tool].offset = tool_offset(run.scene, clock, tool.tool, clock.stage_time);
  solid.last_step = dt;
  follow_extremes(run.scene, clock, solid, run.outcome.facts.diagnostics.extremes);
  solid.next_step = next_step(run.scene, clock, solid, dt, std::max(dt, rejected ? dt : solid.next_step), outcome);
  if (cools) follow_cooling(surface_tension(solid, clock.time), run.outcome.facts.diagnostics.cooling);
  return true;
}

/// Lets the glass cool from here on, and notes the container as it is.
void start_cooling(RunInProgress& run, SolidState& solid) {
  const SolidExtent size = extent_of(solid);
  CoolingSeen& seen = run.outcome.facts.diagnostics.cooling;
  seen.capacity = solid_wall(solid).capacity;
  seen.height = size.high - size.low;
  seen.diameter = 2 * size.radius;
  seen.volume = whole_volume(solid);
  begin_cooling(solid);
}

/// False where the present places of glass and tools do not let it; the facts say why.
bool begin_stage(RunInProgress& run, Index stage, SolidState& solid) {
  State& clock = run.outcome.state;
  clock.stage = stage;
  clock.stage_time = 0;
  clock.stage_start = clock.time;
  clock.last_step = 0;
  const Stage& entered = run.scene.stages[stage];
  const SolidExtent size = extent_of(solid);
  place_under_glass(run.scene, stage, entered.gravity > 0 ? size.high : -size.low, clock);
  if (entered.cools && !remembers(solid)) start_cooling(run, solid);
  solid.next_step = first_step(run.scene, stage);
  solid.glass.velocity.resize(0);  // pressures jump between stages
  notify(run, &RunObserver::stage_begins);
  return !ends_by(run, after_press(run.outcome.facts, cannot_begin(run, solid)));
}

StageEnd present_end(const RunInProgress& run, const SolidState& solid) {
  const State& clock = run.outcome.state;
  return stage_end(run.scene, clock, end_measure(run.scene, clock, clock.stage_time, solid));
}

/// Whether steps are so short that the stage would take thousands more of them; the facts then say so.
bool is_stalled(RunInProgress& run, const SolidState& solid, StallWatch& watch) {
  constexpr double short_step = 10;  // times numerics.min_step, as of round glass
  if (run.scene.stages[run.outcome.state.stage].cools) return false;
  Diagnostics& seen = run.outcome.facts.diagnostics;
  if (solid.last_step < short_step * run.scene.accuracy.min_step) ++seen.steps.short_steps;
  return ends_by(run, watch.reason(run.scene, run.outcome.state, seen));
}

bool advance_stage(RunInProgress& run, SolidState& solid, SolidWorkspace& workspace) {
  const State& clock = run.outcome.state;
  StallWatch watch;
  workspace.heat.begin_anew();
  while (present_end(run, solid) == StageEnd::none) {
    const double before = clock.time;
    if (!step_once(run, solid, workspace)) return false;
    if (ends_by(run, outgrown(run, solid)) || is_stalled(run, solid, watch)) return false;
    notify(run, &RunObserver::solid_step_taken, solid);
    if (!outputs_due(run.scene, clock.stage, before, clock.time).empty())
      notify(run, &RunObserver::solid_fields_due, solid);
    if (clock.totals.steps % steps_to_checkpoint == 0) {
      workspace.heat.begin_anew();
      offer_checkpoint(run, false);
    }
    if (stop_requested(run)) return false;
  }
  return true;
}

void record_stage(RunInProgress& run, const SolidState& solid, bool good) {
  const State& clock = run.outcome.state;
  const char* reason = run.outcome.facts.stopped ? "stop" : good ? name_of(present_end(run, solid)) : "failure";
  run.outcome.facts.stages.push_back({run.scene.stages[clock.stage].name, clock.stage_start, clock.time, reason});
}

}  // namespace

bool run_solid_stages(RunInProgress& run) {
  State& clock = run.outcome.state;
  bool good = true;
  if (!run.outcome.solid) {
    clock.stage = run.scene.solid->from_stage;  // a parison that cannot be followed fails there
    clock.stage_time = 0;
    clock.stage_start = clock.time;
    try {
      run.outcome.solid = std::make_shared<SolidState>(hand_over(run.scene, clock, solid_cell_size(run.scene, clock)));
    } catch (const core::RunError& error) {
      throw core::RunError(after_press(run.outcome.facts, error.what()));
    }
    good = begin_stage(run, run.scene.solid->from_stage, *run.outcome.solid);
    notify(run, &RunObserver::solid_fields_due, *run.outcome.solid);
  }
  SolidState& solid = *run.outcome.solid;
  SolidWorkspace workspace;
  for (;;) {
    good = good && advance_stage(run, solid, workspace);
    if (!run.outcome.facts.stopped) offer_checkpoint(run, true);
    notify(run, &RunObserver::solid_fields_due, solid);
    record_stage(run, solid, good);
    notify(run, &RunObserver::stage_ends);
    const Index next = clock.stage + 1;
    if (!good || next == static_cast<Index>(run.scene.stages.size())) return good;
    good = begin_stage(run, next, solid);
  }
}

}  // namespace parison::forming
