// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/step_loop.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "forming/remeshing/remesh_criteria.hpp"
#include "forming/run/fast_glass.hpp"
#include "forming/run/room_in_tool.hpp"
#include "forming/scene/describe/support.hpp"
#include "forming/step/contact/film.hpp"
#include "forming/step/step.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {

namespace {

/// Longest step after a rejected one, of the rejected one.
constexpr double longest_retry = 0.9;

constexpr const char* remesh_sentence = "Where the results look rough there, a smaller numerics.surface_size helps";
constexpr const char* remesh_advice = "a smaller numerics.surface_size or a larger numerics.quality_floor may help";

/// Tries one step of length dt, s, which `limit` kept from being longer.
StepResult try_step(RunInProgress& run, double dt, StepLimit limit) {
  notify(run, &RunObserver::step_begins);
  StepResult result = coupled_step(run.scene, run.outcome.state, dt, run.workspace);
  result.report.limit = limit;
  notify(run, &RunObserver::step_tried, result);
  for (const auto& [part, seconds] : result.report.seconds) run.outcome.facts.timing[part] += seconds;
  return result;
}

/// Makes the result of a step the state of the run.
void accept(RunInProgress& run, StepResult& result, const ProposedStep& proposed, AcceptedStep& step) {
  State& state = run.outcome.state;
  follow(run.scene, state, result, run.outcome.facts.diagnostics);
  result.state.next_step = proposed.dt;
  result.state.next_limit = static_cast<Index>(proposed.limit);
  step = {std::move(state), std::move(result.report)};
  state = std::move(result.state);
  run.outcome.facts.reason.clear();
}

/// Whether it is gravity that moves the glass: no pressure acts, and in the present stage gravity has done most of the
/// work.
bool gravity_alone_moves(const RunInProgress& run) {
  constexpr double most = 0.8;
  const State& state = run.outcome.state;
  const auto& pressure = run.scene.stages[state.stage].pressure;
  const auto acts = [&](const auto& on_boundary) { return on_boundary.second(state.stage_time) != 0; };
  if (std::any_of(pressure.begin(), pressure.end(), acts)) return false;
  const auto& ended = run.outcome.facts.stages;
  const Work before = ended.empty() ? Work{} : ended.back().work, &now = state.totals.work;
  const double gravity = now.gravity - before.gravity, tools = now.tools - before.tools;
  return gravity > most * (gravity + std::max(0.0, tools));
}

/// Where glass falls by its weight, as a sentence; empty where it does not. Without inertia nothing else limits how
/// fast a thread of it gets.
std::string falling_glass(const RunInProgress& run) {
  const auto fast = fast_glass(run.outcome.state);
  if (!fast || !gravity_alone_moves(run)) return "";
  const std::string note = run.outcome.state.stage == 0 ? falling_note(run.scene) : "";
  return note.empty() ? falls(*fast) : note;
}

/// The same where glass falls or the air blows up a film.
std::string lost_glass(const RunInProgress& run) {
  if (const std::string falling = falling_glass(run); !falling.empty()) return falling;
  const auto fast = fast_glass(run.outcome.state);
  return fast ? bursts(*fast) : "";
}

/// Sets the next step shorter after a rejected one of length dt, s; false when none is worth trying.
bool shorten_step(RunInProgress& run, const StepResult& result, const ProposedStep& proposed, double dt) {
  State& state = run.outcome.state;
  std::string& reason = run.outcome.facts.reason;
  run.workspace.static_stage.reset();
  reason = result.converged ? "the step deforms the glass too much" : result.reason;
  const double next = result.converged ? std::clamp(proposed.dt, shorten * dt, longest_retry * dt) : shorten * dt;
  if (result.unrecoverable) return false;
  if (next < run.scene.accuracy.min_step) {
    const std::string film = lost_glass(run);
    reason += fmt::format("; steps below {:g} s, numerics.min_step, would be needed", run.scene.accuracy.min_step);
    if (!film.empty()) reason = fmt::format("{} (numerics: {})", film, reason);
    return false;
  }
  state.next_step = next;
  state.next_limit = static_cast<Index>(result.converged ? proposed.limit : StepLimit::failure);
  return true;
}

/// The steps of one moment that were refused because they move an edge into a tool. A shorter step does not help where
/// the edge has slipped over a corner and its cell is too flat to let it out; a new mesh has a node at the corner.
class RefusedEdges {
 public:
  /// True, once, where the step refused last is hardly less deep than a longer one before.
  bool ask_for_mesh(const StepResult& refused) {
    constexpr double hardly_less = 0.6;
    const double before = std::exchange(depth_, refused.edge_depth);
    if (asked_ || before == 0 || refused.edge_depth < hardly_less * before) return false;
    asked_ = true;
    return true;
  }

 private:
  double depth_ = 0;  ///< of the last refused step, m
  bool asked_ = false;
};

/// Refuses a step that ends with a film too thin to go on and is so long that shorter ones may come to the end of the
/// stage before that: a film closes with the speed of the tools, whatever the rest of the glass allows.
void refuse_closed_film(const Scene& scene, double dt, StepResult& result) {
  if (!result.converged || !scene.has_flow() || scene.stages[result.state.stage].cools ||
      dt <= scene.accuracy.initial_step)
    return;
  const std::string film = film_failure(scene, result.state);
  if (film.empty()) return;
  result.converged = false;
  result.reason = film;
}

/// The length, s, of a step that ends with the stage, instead of one of length dt, s, that goes beyond that; `dt` where
/// it does not. Tools slow down ever faster as they come to rest, so that a step to the moment predicted before it is
/// too long; what else ends a stage is not predicted.
double up_to_end(const Scene& scene, const State& before, const StepResult& result, double dt) {
  const double beyond_rest = -time_to_rest(scene, result.state);
  const double share =
      share_until_end(scene.stages[result.state.stage], end_measure(scene, before), end_measure(scene, result.state));
  return shortened_to_end(dt, std::max(beyond_rest < dt ? beyond_rest : 0, (1 - share) * dt), result.state.next_step);
}

/// A step that converged and kept within its allowance; false when the smallest one did not.
bool step_once(RunInProgress& run, AcceptedStep& step) {
  const State& state = run.outcome.state;
  const double first_try = state.next_step;
  constexpr int most_repeats = 4;  // up to the end of the stage
  int repeats = 0;
  RefusedEdges edges;
  double dt = clip_step_to_event(run.scene, state, state.next_step);
  auto limit = dt < state.next_step ? StepLimit::event : static_cast<StepLimit>(state.next_limit);
  for (;;) {
    StepResult result = try_step(run, dt, limit);
    refuse_closed_film(run.scene, dt, result);
    const bool sound = result.converged && !rejected_by_error_control(run.scene, result.report);
    const double until_end = sound && repeats < most_repeats ? up_to_end(run.scene, state, result, dt) : dt;
    const bool accepted = sound && until_end == dt;
    add_step(run.scene, result.report, accepted, run.outcome.facts.diagnostics.steps);
    if (sound && !accepted) {
      ++repeats;
      run.workspace.static_stage.reset();
      dt = until_end;
      limit = StepLimit::event;
      continue;
    }
    const ProposedStep proposed = propose_step(run.scene, state, result.report, accepted ? state.next_step : dt);
    if (accepted) {
      accept(run, result, proposed, step);
      return true;
    }
    if (!shorten_step(run, result, proposed, dt) || stop_requested(run)) return false;
    if (edges.ask_for_mesh(result) && remesh_glass(run, RemeshReason::quality)) run.outcome.state.next_step = first_try;
    dt = clip_step_to_event(run.scene, state, state.next_step);
    limit = static_cast<StepLimit>(state.next_limit);
  }
}

}  // namespace

bool remesh_glass(RunInProgress& run, RemeshReason why) {
  const bool must = why == RemeshReason::failed_step;
  auto remeshed = [&] {
    const core::ScopedTimer timer(run.outcome.facts.timing["remesh"]);
    return remesh_state(run.scene, run.outcome.state, why, run.mesher);
  }();
  if (remeshed.ok) {
    run.outcome.state = std::move(remeshed.state);
    run.workspace.flow.reset();
    return true;
  }
  const std::string sentence = fmt::format("no new glass mesh: {}", remeshed.reason);
  State& state = run.outcome.state;
  if (++state.totals.remeshing.failed == 1)
    run.outcome.facts.warnings.push_back(
        fmt::format("at {:.5f} s {}; the run goes on with the old one. {}", state.time, sentence, remesh_sentence));
  auto& reason = run.outcome.facts.reason;
  if (must) reason += fmt::format("{}{}; {}", reason.empty() ? "" : "; ", sentence, remesh_advice);
  return !must;
}

bool has_outgrown_tool(RunInProgress& run) {
  return gravity_alone_moves(run) && ends_by(run, outgrown_tool(run.scene, run.outcome.state));
}

bool advance(RunInProgress& run, AcceptedStep& step) {
  const Scene& scene = run.scene;
  if (ends_by(run, falling_glass(run))) return false;
  const bool may_remesh = scene.has_flow() && !scene.stages[run.outcome.state.stage].cools;
  if (may_remesh && needs_remesh(scene, run.outcome.state) && !remesh_glass(run, RemeshReason::quality)) return false;
  if (step_once(run, step)) return true;
  if (run.outcome.facts.stopped) return false;
  // A mesh that is still sound may be what holds the step back.
  return may_remesh && remesh_glass(run, RemeshReason::failed_step) && step_once(run, step);
}

}  // namespace parison::forming
