#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/step_result.hpp"
#include "forming/step/step_start.hpp"
#include "forming/step/workspace.hpp"

namespace parison::forming {

/// Lets the glass remember from now on: without stress, its structure in equilibrium.
void begin_cooling(State& state);

/// Whether it does.
inline bool remembers(const State& state) {
  return state.glass.branch_stress.size() > 0;
}

/// A step of glass that remembers its stress (forming/cooling): half the motion expected, heat, then the equilibrium in
/// the middle of the step at the temperatures that the heat gave, and the whole motion. Of second order in time.
StepResult cooling_step(const StepStart& start, Workspace& workspace);

/// Stress of glass that cools, by node, Pa: rr, zz, hoop, rz; tension positive. Empty where it does not. On the
/// surface alone, zero elsewhere, where `only_surface`.
Eigen::VectorXd nodal_stress(const GlassState& glass, bool only_surface = false);
/// Its fictive temperature, by node, K.
Eigen::VectorXd nodal_fictive_temperature(const Scene& scene, const GlassState& glass);

}  // namespace parison::forming
