// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/run/remaining_time.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "forming/scene/preset_scales.hpp"

namespace parison::tools {
namespace {

using forming::Index;
using forming::Scene;
using forming::Stage;

/// Length of the contact boundaries of a body's section, m.
double contact_length(const forming::Body& body) {
  double length = 0;
  for (const auto& segment : body.profile.segments)
    if (body.boundaries[static_cast<std::size_t>(segment.boundary_id)].kind == forming::BoundaryKind::contact)
      length += core::length(segment);
  return length;
}

bool is_pressed(const Stage& stage) {
  return std::any_of(stage.tools.begin(), stage.tools.end(), [](const auto& tool) { return tool.moves(); });
}

/// Steps that grow from the first to the longest, and go on with that.
double quiet_steps(const Scene& scene, const Stage& stage) {
  constexpr double growth = 1.5;
  const double longest = forming::longest_step(scene, stage);
  return std::log(longest / scene.accuracy.initial_step) / std::log(growth) + stage.duration / longest;
}

/// Steps to come in a stage of which so many were expected: what is left of them, or of its time where it has taken
/// more and nothing but its duration ends it.
double steps_to_come(const forming::RunView& run, double taken, double expected) {
  constexpr double least = 0.1;  // of those taken
  if ((1 + least) * taken <= expected) return expected - taken;
  const Stage& stage = run.scene.stages[static_cast<std::size_t>(run.state.stage)];
  if (stage.may_end_early()) return least * taken;
  const double over = run.state.stage_time / stage.duration;
  return std::max(least * taken, (1 - over) * expected);
}

}  // namespace

std::vector<double> expected_steps(const Scene& scene) {
  std::vector<bool> met(scene.tools.size(), false);
  std::vector<double> steps;
  for (const Stage& stage : scene.stages) {
    double length = 0;
    // Glass between tools meets them from two sides for most of a press, blown glass lands on a mould nearly in a row.
    const double fronts =
        is_pressed(stage) ? 1.5 : 1.1;  // at a time; tests/remaining_time measures what they are worth
    if (scene.has_flow() && (is_pressed(stage) || !stage.pressure.empty()))
      for (const auto& tool : stage.tools)
        if (const auto index = static_cast<std::size_t>(tool.tool); !met[index]) {
          met[index] = true;
          length += contact_length(scene.tools[index]);
        }
    steps.push_back(quiet_steps(scene, stage) +
                    length / (fronts * scene.accuracy.landing_per_step * scene.accuracy.surface_size));
  }
  return steps;
}

void RemainingTime::run_begins(const forming::RunView& run) {
  expected_ = expected_steps(run.scene);
  steps_at_start_ = steps_at_stage_ = run.state.totals.steps;
}

void RemainingTime::stage_begins(const forming::RunView& run) {
  const auto stage = static_cast<std::size_t>(run.state.stage);
  if (run.state.totals.steps > steps_at_start_ && stage > 0) expected_of_done_ += expected_[stage - 1];
  steps_at_stage_ = run.state.totals.steps;
}

double RemainingTime::fraction_done(const forming::RunView& run) {
  const auto stage = static_cast<std::size_t>(run.state.stage);
  const double here = run.state.totals.steps - steps_at_stage_, before = steps_at_stage_ - steps_at_start_;
  // A press says little of a blow: what is expected of the whole run counts as much as what was seen.
  const double weight = std::accumulate(expected_.begin(), expected_.end(), 0.0);
  const auto seen_over_expected = [&](double seen, double expected) { return (seen + weight) / (expected + weight); };
  double ratio = seen_over_expected(before, expected_of_done_);
  double to_come = steps_to_come(run, here, ratio * expected_[stage]);
  ratio = std::max(ratio, seen_over_expected(before + here, expected_of_done_ + expected_[stage]));
  for (std::size_t i = stage + 1; i < expected_.size(); ++i) to_come += ratio * expected_[i];
  return (before + here) / std::max(before + here + to_come, 1.0);
}

}  // namespace parison::tools
