#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/run/run_in_progress.hpp"

namespace parison::forming {

/// Why the present stage cannot begin with the present positions of tools and glass; empty when it can.
std::string stage_precondition_failure(const Scene& scene, const State& state);
/// The same of the first stage, at the start of a run.
std::string first_stage_failure(const Scene& scene);

/// Why a stage cannot begin, after what the press before has left unfilled where it has; empty when it can.
std::string after_press(const RunFacts& facts, const std::string& failure);

/// Length of the first step of a stage, s. Nothing presses in one that cools.
double first_step(const Scene& scene, Index stage);

/// Enters a stage; false when it cannot begin, and the facts say why.
bool begin_stage(RunInProgress& run, Index stage);

/// Notes the largest forces of tools that a force drives, and whether one has moved faster than the speed that ends the
/// stage.
void update_motion(const Scene& scene, State& state);

/// Records how a stage ended.
void end_stage(RunInProgress& run, bool good);

}  // namespace parison::forming
