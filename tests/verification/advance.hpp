#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "forming/step.hpp"
#include "forming/step_control.hpp"

namespace parison::forming {

/// Steps as `run` does, without its files, to a time of the first stage.
inline State advance_to(const Scene& scene, State state, double time, Workspace& workspace) {
  if (state.next_step == 0) state.next_step = scene.accuracy.first_step;
  while (state.time < time - 1e-12) {
    const double dt = std::min(landing_step(scene, state, state.next_step), time - state.time);
    auto result = coupled_step(scene, state, dt, workspace);
    EXPECT_TRUE(result.converged) << result.reason;
    if (!result.converged) break;
    result.state.next_step = wished_step(scene, result.report, state.next_step).dt;
    state = std::move(result.state);
  }
  return state;
}

}  // namespace parison::forming
