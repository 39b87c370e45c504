// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/step_control.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "forming/scene/preset_scales.hpp"
#include "forming/step/contact/first_touch.hpp"

namespace parison::forming {

namespace {

/// Largest factors by which a step may grow on the one before, in general and in slow phases, in which a step used less
/// than `slow_fraction` of what it may change.
constexpr double max_growth = 1.5, max_slow_growth = 3.0, slow_fraction = 0.1;
constexpr double safety_factor = 0.9;  ///< of the step that would change just as much as a step may
constexpr double reject_above = 3.0;   ///< times what a step may change
/// Times the shortest step allowed: shorter ones are not repeated for an error of the work, a share of that of the run,
/// that is less than this, nor for a change of temperature, which is that of a thin cell between cold and hot glass
/// where a fold has closed.
constexpr double shortest_to_repeat = 10, bearable_work_error = 1e-3;
/// Smaller jumps of a tool's speed, as shares of its largest speed, need no step of their own.
constexpr double kink_share = 0.05;
/// Towards the moment at which tools come to rest no step is shorter than this share of the one proposed.
constexpr double shortest_to_rest = 0.1;

double work_share(const Scene& scene, const StepReport& report) {
  return std::sqrt(report.work_error / scene.accuracy.work_per_step);
}

/// By how much heat that was not foreseen made a step wrong, over what it may be. A spot of stiff glass may open and
/// close at every step, however short, by the heat that its contact passes. The motion is wrong by the deformation of
/// such a step at the most: one as small as the error of a step of the longest deformation, its square, is not
/// shortened.
double unforeseen_share(const Scene& scene, const StepReport& report) {
  const double share = std::sqrt(report.unforeseen_error / scene.accuracy.work_per_step);
  if (!report.flickers) return share;
  const double small = scene.accuracy.strain_per_step * scene.accuracy.strain_per_step;
  return std::min(share, std::max(safety_factor, report.strain / small));
}

/// What a step with such a landed length, m, and error of the work changed over what it may change (the largest share
/// of strain, landing, work, temperature and motion), and which it was.
std::pair<double, StepLimit> load(const Scene& scene, const StepReport& report, double landed, double work_error) {
  return std::max(
      {std::pair(report.strain / scene.accuracy.strain_per_step, StepLimit::strain),
       std::pair(landed / (scene.accuracy.landing_per_step * scene.accuracy.surface_size), StepLimit::landing),
       std::pair(std::sqrt(work_error / scene.accuracy.work_per_step), StepLimit::work),
       std::pair(unforeseen_share(scene, report), StepLimit::temperature),
       std::pair(report.temperature_change / scene.accuracy.temperature_per_step, StepLimit::temperature),
       std::pair(report.predictor_corrector_difference / scene.accuracy.motion_tolerance, StepLimit::motion)});
}

/// The length, m, that a step lands at the mean speed of this and the one before: glass lands edge by edge, so that of
/// steps alike one lands two edges and the next one none.
double mean_landed(const State& start, const StepReport& report) {
  if (start.last_step == 0) return report.landed_length;
  return report.dt * (start.last_landed + report.landed_length) / (start.last_step + report.dt);
}

/// The error of the work of such a step, from this and the one before, in which it goes with the square of the step.
double mean_work_error(const State& start, const StepReport& report) {
  if (start.last_step == 0) return report.work_error;
  const double ratio = report.dt / start.last_step;
  return std::min(report.work_error, 0.5 * (report.work_error + start.last_work_error * ratio * ratio));
}

/// s; the output of a stage that cools is even over its duration.
double output_interval(const Scene& scene, Index stage) {
  constexpr int outputs = 6;
  return scene.stages[stage].cools ? scene.stages[stage].duration / outputs : scene.output.interval;
}

double next_output(const Scene& scene, Index stage, double time) {
  const double interval = output_interval(scene, stage);
  double next =
      interval > 0 ? interval * (std::floor(time / interval + same_time) + 1) : std::numeric_limits<double>::infinity();
  for (const double t : scene.output.times)
    if (t > time + same_time) next = std::min(next, t);
  return next;
}

/// The next time in the stage, s, at which the speed of a tool that moves by position jumps; infinite for none.
double next_kink(const Scene& scene, const State& state) {
  double next = std::numeric_limits<double>::infinity();
  for (const StageTool& tool : scene.stages[state.stage].tools)
    if (const auto* motion = std::get_if<PositionMotion>(&tool.motion))
      for (const double kink : core::kinks(motion->offset, kink_share))
        if (kink > state.stage_time + same_time) next = std::min(next, kink);
  return next;
}

/// Calls visit(curve, of_stage) for what is given over time and acts in a stage: over the time of the stage or of the
/// run.
template <typename Visit>
void for_each_curve(const Scene& scene, const Stage& stage, const Visit& visit) {
  for (const auto& [name, pressure] : stage.pressure) visit(pressure, true);
  for (const StageTool& tool : stage.tools)
    if (const auto* driven = std::get_if<ForceMotion>(&tool.motion)) {
      visit(driven->force, true);
      visit(driven->speed_limit, true);
    }
  for (const StageCooling& cooling : stage.cooling) {
    visit(cooling.h, true);
    visit(cooling.air_temperature, true);
  }
  const auto visit_exchange = [&](const thermal::SurfaceExchange& exchange, bool of_stage) {
    for (const auto* curve : {&exchange.h, &exchange.air_temperature, &exchange.ambient_temperature})
      visit(*curve, of_stage);
  };
  for (const Air* air : airs_of(stage)) visit_exchange(*air, air->of_stage);
  for (Index body = 0; body <= static_cast<Index>(scene.tools.size()); ++body)
    for (const Boundary& boundary : body_of(scene, body).boundaries) {
      visit_exchange(boundary.cooling, false);
      visit(boundary.temperature, false);
    }
}

/// The time, s, in which no pressure and no force given over time changes by more than numerics.strain_per_step of its
/// largest size: contact presses and conducts by them.
double load_step(const Scene& scene, const State& state) {
  double longest = std::numeric_limits<double>::infinity();
  const auto include = [&](const core::TimeFunction& load) {
    const double rate = std::abs(load.derivative(state.stage_time + same_time));
    if (rate > 0) longest = std::min(longest, scene.accuracy.strain_per_step * load.max_size() / rate);
  };
  const Stage& stage = scene.stages[state.stage];
  for (const auto& [name, pressure] : stage.pressure) include(pressure);
  for (const StageTool& tool : stage.tools)
    if (const auto* driven = std::get_if<ForceMotion>(&tool.motion)) include(driven->force);
  return longest;
}

/// The next time in the stage, s, at which something given over time bends; infinite for none.
double next_corner(const Scene& scene, const State& state) {
  double next = std::numeric_limits<double>::infinity();
  for_each_curve(scene, scene.stages[state.stage], [&](const core::TimeFunction& curve, bool of_stage) {
    const double start = of_stage ? 0 : state.stage_start;
    next = std::min(next, curve.next_corner(start + state.stage_time + same_time) - start);
  });
  return next;
}

}  // namespace

ProposedStep propose_step(const Scene& scene, const State& state, const StepReport& report, double allowed) {
  const bool refused = rejected_by_error_control(scene, report);
  const auto [used, by] = refused ? load(scene, report, report.landed_length, report.work_error)
                                  : load(scene, report, mean_landed(state, report), mean_work_error(state, report));
  ProposedStep proposed{(used < slow_fraction ? max_slow_growth : max_growth) * std::max(report.dt, allowed),
                        StepLimit::growth};
  if (used > 0 && report.dt * safety_factor / used < proposed.dt) proposed = {report.dt * safety_factor / used, by};
  if (const double longest = longest_step(scene, scene.stages[state.stage]); proposed.dt > longest)
    proposed = {longest, StepLimit::max_step};
  proposed.dt = std::max(proposed.dt, scene.accuracy.min_step);
  return proposed;
}

bool rejected_by_error_control(const Scene& scene, const StepReport& report) {
  const auto [used, by] = load(scene, report, report.landed_length, report.work_error);
  // What remains in very short steps is none of their length.
  const bool bearable =
      (by == StepLimit::work && report.work_error < bearable_work_error) || by == StepLimit::temperature;
  return used > reject_above && !(bearable && report.dt < shortest_to_repeat * scene.accuracy.min_step);
}

bool rejected_for_work(const Scene& scene, const StepReport& report) {
  return work_share(scene, report) > reject_above;
}

double clip_step_to_event(const Scene& scene, const State& state, double proposed) {
  proposed = std::max(std::min(proposed, load_step(scene, state)), scene.accuracy.min_step);
  double left = std::min({longest_stage_time(scene, state), next_kink(scene, state), next_corner(scene, state)}) -
                state.stage_time;
  left = std::min(left, std::max(time_to_rest(scene, state), shortest_to_rest * proposed));
  if (scene.has_flow())
    left = std::min(left,
                    std::max(time_to_first_touch(scene, state, std::min(left, 2 * proposed)), scene.accuracy.min_step));
  else
    left = std::min(left, next_output(scene, state.stage, state.time) - state.time);
  if (left <= proposed * (1 + same_time)) return left;
  return left < 2 * proposed ? 0.5 * left : proposed;
}

std::vector<double> outputs_due(const Scene& scene, Index stage, double from, double to) {
  std::vector<double> due;
  const auto next = [&](double time) { return next_output(scene, stage, time); };
  for (double t = next(from); t <= to + same_time; t = next(t)) due.push_back(to - t < same_time ? to : t);
  return due;
}

}  // namespace parison::forming
