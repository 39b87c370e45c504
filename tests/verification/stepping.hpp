#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "forming/diagnostics/diagnostics.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/step.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {

/// Sees the states around a step.
using Look = std::function<void(const State& before, const State& after)>;

/// Steps as `run` does, without its files and new meshes, to a time of the first stage; `seen` follows them.
inline State steps_to(const Scene& scene, State state, double time, Workspace& workspace, const Look& look = {},
                      Diagnostics* seen = nullptr) {
  if (state.next_step == 0) state.next_step = scene.accuracy.initial_step;
  while (state.time < time - 1e-12) {
    const double dt = std::min(clip_step_to_event(scene, state, state.next_step), time - state.time);
    auto result = coupled_step(scene, state, dt, workspace);
    EXPECT_TRUE(result.converged) << result.reason;
    if (!result.converged) break;
    const double proposed = propose_step(scene, state, result.report, state.next_step).dt;
    if (!rejected_by_error_control(scene, result.report)) {
      if (look) look(state, result.state);
      if (seen) follow(scene, state, result, *seen);
      state = std::move(result.state);
    }
    state.next_step = proposed;
  }
  return state;
}

inline State steps_to(const Scene& scene, State state, double time, const Look& look = {},
                      Diagnostics* seen = nullptr) {
  Workspace workspace;
  return steps_to(scene, std::move(state), time, workspace, look, seen);
}

}  // namespace parison::forming
