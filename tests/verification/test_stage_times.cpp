// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "figure.hpp"
#include "forming/run/run.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {
namespace {

Scene bar_scene(const char* name, const char* accuracy) {
  return read_scene(std::string(PARISON_SOURCE_DIR) + "/tests/bars/scenes/" + name + ".toml", accuracy);
}

/// By how much the end of a stage is off, as shares of the exact time and thickness.
struct EndError {
  double time, thickness;
};

/// A disc is pressed by a force between slipping plates until the plate is slower than the stage's end speed.
EndError error_of_end(const char* accuracy) {
  const RunOutcome outcome = run(bar_scene("squeeze_slip", accuracy));
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_EQ(outcome.facts.stages.back().end_reason, "tools at rest");
  const double volume = M_PI * 0.01 * 0.01 * 0.01, rate = 200 / (3 * 1e4 * volume);
  const double height = std::sqrt(8e-3 / rate), exact = (1 / height - 1 / 0.01) / rate;
  double top = 0;
  for (const Point& x : outcome.state.glass.mesh.nodes) top = std::max(top, x[1]);
  return {std::abs(outcome.state.time / exact - 1), std::abs(top / height - 1)};
}

TEST(StageTimes, a_stage_ends_when_its_tool_comes_to_rest_and_not_at_the_end_of_that_step) {
  double standard = 0;
  for (const char* accuracy : {"draft", "standard", "fine"}) {
    const double off = error_of_end(accuracy).time;
    std::printf("squeeze until the plate is slow, %s: time off by %.2e\n", accuracy, off);
    if (std::string(accuracy) == "standard") standard = off;
  }
  tests::expect_at_most("disc squeezed until the plate is slow, standard: time off by", standard, 0.01);
}

TEST(StageTimes, a_step_beyond_the_moment_at_which_its_tool_comes_to_rest_is_repeated_up_to_there) {
  tests::Figure time("disc squeezed until the plate is slow, seven accuracies about draft: time off by"),
      thickness("  and its thickness");
  for (const char* factor : {"2", "1.7", "1.4", "1.19", "1", "0.84", "0.7"}) {
    const EndError off = error_of_end((std::string("draft coarser ") + factor).c_str());
    time.add(off.time);
    thickness.add(off.thickness);
  }
  time.at_most(0.015);
  thickness.at_most(0.004);
}

TEST(StageTimes, steps_end_where_a_tool_moved_by_its_position_changes_its_speed) {
  struct Times : RunObserver {
    double nearest = 1;
    void step_taken(const RunView& run, const State&, const StepReport&) override {
      nearest = std::min(nearest, std::abs(run.state.time - 0.2));
    }
  } times;
  const RunOutcome outcome = run(bar_scene("squeeze_stick", "draft"), {&times});
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_LT(times.nearest, 1e-12);
}

TEST(StageTimes, a_ring_that_bends_faster_than_the_step_does_not_shorten_it) {
  const RunOutcome outcome = run(bar_scene("ring", "draft"));
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_LT(outcome.state.totals.steps, 60);
  const double area = 26.0 * 26 - 20.0 * 20, ratio = std::pow(20.0 / 26, 2) * std::exp(0.4);
  const double outer = 1e-3 * std::sqrt(area / (1 - ratio));
  double largest = 0;
  for (const Point& x : outcome.state.glass.mesh.nodes) largest = std::max(largest, std::abs(x.norm() / outer));
  tests::expect_at_most("planar ring widened at draft: outer radius off by", std::abs(largest - 1), 3e-3);
}

}  // namespace
}  // namespace parison::forming
