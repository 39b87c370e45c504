// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../scene_text.hpp"
#include "forming/run/stall.hpp"

namespace parison::forming {
namespace {

/// What is said after each of some steps of a length, s, the first that is anything.
std::string after_steps(const Scene& scene, Index count, double dt) {
  State state{};
  Diagnostics seen;
  StallWatch watch;
  for (Index i = 0; i < count; ++i) {
    ++state.totals.steps;
    if (dt < 10 * scene.accuracy.min_step) ++seen.steps.short_steps;
    state.stage_time += dt;
    if (std::string said = watch.reason(scene, state, seen); !said.empty()) return said;
  }
  return "";
}

TEST(Stall, hundreds_of_the_shortest_steps_end_a_run_that_has_a_million_of_them_to_come) {
  const Scene scene = scene_of(small_scene);
  const std::string said = after_steps(scene, 1000, 1e-6);
  EXPECT_NE(said.find("the last 150 steps, of 1e-06 s on average, were about as short as numerics.min_step"), said.npos)
      << said;
  EXPECT_EQ(after_steps(scene, 1000, 1e-4), "") << "long enough";
  EXPECT_EQ(after_steps(scene, 100, 1e-6), "") << "too few";
  EXPECT_EQ(after_steps(scene_of(replaced("duration = \"1 s\"", "duration = \"2 ms\"")), 1000, 1e-6), "")
      << "the stage is over soon";
}

TEST(Stall, glass_deep_behind_a_face_without_contact_ends_a_run) {
  const Scene scene = scene_of(small_scene);
  const State state{};
  Diagnostics seen;
  seen.in_tools.entered_tool = 0;
  seen.in_tools.node.share = 0.05;
  EXPECT_EQ(StallWatch().reason(scene, state, seen), "");
  seen.in_tools.node.share = 0.12;
  EXPECT_EQ(StallWatch().reason(scene, state, seen), "glass is inside the tool by 12 % of its mean wall");
}

}  // namespace
}  // namespace parison::forming
