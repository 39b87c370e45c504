#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "forming/initial_state.hpp"
#include "forming/step.hpp"
#include "forming/step_control.hpp"

namespace parison::forming {

/// Steps as `run` does, without its files and new meshes, to a time of the first stage; `look` sees each state before and after.
inline State steps_to(const Scene& scene, State state, double time,
                      const std::function<void(const State&, const State&)>& look = {}) {
  Workspace workspace;
  state.next_step = scene.accuracy.first_step;
  while (state.time < time - 1e-12) {
    const double dt = std::min(landing_step(scene, state, state.next_step), time - state.time);
    auto result = coupled_step(scene, state, dt, workspace);
    EXPECT_TRUE(result.converged) << result.reason;
    if (!result.converged) break;
    const double wish = wished_step(scene, result.report, state.next_step).dt;
    if (!overshot(scene, result.report)) {
      if (look) look(state, result.state);
      state = std::move(result.state);
    }
    state.next_step = wish;
  }
  return state;
}

/// A scene from the text of its case file.
inline Scene scene_from(const std::string& text, const std::string& accuracy) {
  const auto folder = std::filesystem::temp_directory_path() / ("parison_verification_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "case.toml") << text;
  const Scene scene = read_scene(folder.string(), accuracy);
  std::filesystem::remove_all(folder);
  return scene;
}

}  // namespace parison::forming
