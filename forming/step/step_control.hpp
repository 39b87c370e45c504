#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <vector>

#include "core/math/numbers.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/step/step_result.hpp"

namespace parison::forming {

struct ProposedStep {
  double dt;  ///< s
  StepLimit limit;
};

/// The length of the next step of the stage that a state is in, from what the last one changed (strain, surface
/// temperature, predictor against corrector); `allowed`, s, is the length that was proposed for the last one before it
/// was clipped to an event.
ProposedStep propose_step(const Scene& scene, const State& state, const StepReport& report, double allowed);

/// Whether a step changed three times more than it may, so that it is rejected and repeated shorter.
bool rejected_by_error_control(const Scene& scene, const StepReport& report);

/// Whether it would be for the error of its work alone.
bool rejected_for_work(const Scene& scene, const StepReport& report);

/// The proposed step, s, clipped so that the stage's end is met exactly and no very short step is left before it. Where
/// nothing flows it is clipped to the next output time too; the heat integrator's own steps do not depend on that.
double clip_step_to_event(const Scene& scene, const State& state, double proposed);

/// Output times of a stage after `from` and not after `to`, s, in order; one that cools has its own.
std::vector<double> outputs_due(const Scene& scene, Index stage, double from, double to);

/// The condition by which a stage ends; `none` while it goes on.
enum class StageEnd { none, duration, tools_at_rest, force, filled, surface_below, surface_above, lowest };
/// What it is called in the results.
const char* name_of(StageEnd end);

using core::same_time;

/// Time, s, until all driven tools are slower than the stage's end speed, as their speeds fall now: negative where they
/// have been for some time, infinite where they do not fall or have not been faster yet.
double time_to_rest(const Scene& scene, const State& state);

/// What a condition that ends a stage is about, in its unit: the largest force of a tool, the share near tools, the
/// mean temperature of the surface, or the lowest place of the glass.
using EndMeasure = std::function<double(const EndCondition&)>;
/// Of a round state.
EndMeasure end_measure(const Scene& scene, const State& state);

/// The share of a step after which the first of the stage's conditions held that holds at its end and not at its start,
/// as on a straight line between both; 1 where there is none.
double share_until_end(const Stage& stage, const EndMeasure& before, const EndMeasure& after);

/// The length, s, of a step that ends with the stage, instead of one of length `dt` that goes beyond it by `beyond`;
/// `dt` where that is little of it or of the `longest` step allowed now.
double shortened_to_end(double dt, double beyond, double longest);

/// How long the present stage lasts unless another condition ends it, s.
double longest_stage_time(const Scene& scene, const State& state);

/// Whether and by which condition the present stage is over: its duration has passed, or its driven tools have moved
/// faster than the end speed and are all slower again, or a condition of the stage holds at the end of a step.
StageEnd stage_end(const Scene& scene, const State& state);
/// The same with another measure of the glass.
StageEnd stage_end(const Scene& scene, const State& clock, const EndMeasure& measure);

}  // namespace parison::forming
