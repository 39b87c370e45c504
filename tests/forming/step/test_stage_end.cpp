// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/run/run.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/flow/predictor.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {
namespace {

const std::string pressed = "duration = \"2 s\"\n";

/// How the press of the small scene ends with these conditions, in a state that has begun it.
StageEnd end_with(const std::string& conditions, double offset = 0, double force = 0, double temperature = 1273.15) {
  const Scene scene = scene_of(replaced(pressed, pressed + "end = { " + conditions + " }\n"));
  State state = initial_state(scene);
  state.stage = 1;
  state.stage_time = 0.1;
  state.tools[1].offset = 0.01 + offset;
  state.tools[1].end_force = force;
  state.glass.temperature.setConstant(temperature);
  return stage_end(scene, state);
}

TEST(StageEnd, a_force_ends_the_stage_whatever_its_sign) {
  EXPECT_EQ(end_with("force = \"4 N\"", 0, -3.9), StageEnd::none);
  EXPECT_EQ(end_with("force = \"4 N\"", 0, -4), StageEnd::force);
  EXPECT_EQ(end_with("force = \"4 N\"", 0, 4.1), StageEnd::force);
}

TEST(StageEnd, a_tool_that_slows_after_a_jolt_is_not_at_rest_and_one_that_goes_on_slowing_is) {
  const Scene scene = scene_of(replaced(pressed, pressed + "end_speed = \"5 mm/s\"\n"));
  State before = initial_state(scene);
  before.stage = 1, before.stage_time = 0.1, before.last_step = 3e-4, before.has_moved = true;
  before.glass.temperature_rate.setZero(before.glass.temperature.size());
  const auto end_after = [&](double speed, double slowing, double next) {
    State start = before, state = before;
    start.tools[1].velocity = -speed, start.tools[1].slowing = slowing;
    state.tools[1].velocity = -next, state.last_step = state.next_step = 3e-4;
    update_rates(start, 3e-4, state);
    return stage_end(scene, state);
  };
  EXPECT_EQ(end_after(47e-3, 0, 10e-3), StageEnd::none);
  EXPECT_EQ(end_after(47e-3, 4000, 10e-3), StageEnd::tools_at_rest);
  EXPECT_EQ(end_after(6e-3, 0, 5.1e-3), StageEnd::tools_at_rest);
}

TEST(StageEnd, the_mean_surface_temperature_ends_it_from_either_side) {
  EXPECT_EQ(end_with("surface_below = \"999 degC\""), StageEnd::none);
  EXPECT_EQ(end_with("surface_below = \"1001 degC\""), StageEnd::surface_below);
  EXPECT_EQ(end_with("surface_above = \"999 degC\""), StageEnd::surface_above);
  EXPECT_EQ(end_with("surface_above = \"1001 degC\""), StageEnd::none);
}

TEST(StageEnd, a_mould_is_filled_by_the_share_of_the_surface_near_its_tools) {
  // A disc of 20 mm by 10 mm lies on the plate.
  const auto ended = [](const std::string& share, double offset) {
    const std::string text = replaced("pressure.surface = \"0.1 bar\"\n", "",
                                      replaced(pressed, pressed + "end = { filled = \"" + share + "\" }\n"));
    const Scene scene = scene_of(text);
    State state = initial_state(scene);
    state.stage = 1, state.stage_time = 0.1, state.tools[1].offset = 0.01 + offset;
    return stage_end(scene, state);
  };
  // Bottom 400, top under the face 225, of 1200 in all (in units of pi mm2): 33.3 % and 52.1 %.
  EXPECT_EQ(ended("32 %", 0.005), StageEnd::filled);
  EXPECT_EQ(ended("36 %", 0.005), StageEnd::none);
  EXPECT_EQ(ended("49 %", 0), StageEnd::filled);
  EXPECT_EQ(ended("56 %", 0), StageEnd::none);
  EXPECT_EQ(ended("49 %", 0.0003), StageEnd::none);
}

TEST(StageEnd, the_lowest_point_counts_in_the_direction_of_gravity) {
  EXPECT_EQ(end_with("lowest = \"0 mm\""), StageEnd::lowest);
  EXPECT_EQ(end_with("lowest = \"-0.1 mm\""), StageEnd::none);
}

TEST(StageEnd, several_conditions_end_it_by_the_first_that_holds_and_none_at_its_very_start) {
  EXPECT_EQ(end_with("force = \"4 N\", surface_below = \"1001 degC\"", 0, 1), StageEnd::surface_below);
  EXPECT_EQ(end_with("force = \"4 N\", surface_below = \"1001 degC\"", 0, 5), StageEnd::force);
  const Scene scene = scene_of(replaced(pressed, pressed + "end.surface_below = \"1001 degC\"\n"));
  State state = initial_state(scene);
  state.stage = 1;
  EXPECT_EQ(stage_end(scene, state), StageEnd::none);
}

TEST(StageEnd, a_run_ends_its_stage_by_the_condition_and_says_so) {
  const Scene scene =
      scene_of(replaced("duration = \"1 s\"\n", "duration = \"1 s\"\nend.surface_below = \"985 degC\"\n"));
  const RunOutcome outcome = run(scene);
  ASSERT_FALSE(outcome.facts.stages.empty());
  EXPECT_EQ(outcome.facts.stages[0].end_reason, "surface below its temperature");
  EXPECT_LT(outcome.facts.stages[0].end, 1);
  EXPECT_GT(outcome.facts.stages[0].end, 0);
}

/// Watches when the mean temperature of the glass surface falls to a limit, by a straight line between two steps.
struct Crossing : RunObserver {
  double limit, at = 0, before = 0, then = 0;
  explicit Crossing(double value) : limit(value) {}
  void step_taken(const RunView& run, const State&, const StepReport&) override {
    const core::Mesh& mesh = run.state.glass.mesh;
    double sum = 0, area = 0;
    for (const auto& edge : mesh.boundary_edges()) {
      if (mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
      const double length = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).norm();
      for (int i = 0; i < 3; ++i) {
        const double radius = run.scene.geometry == core::Geometry::planar ? 1 : mesh.nodes[edge.nodes[i]][0];
        const double part = length * radius * (i == 2 ? 4 : 1) / 6;
        sum += part * run.state.glass.temperature[edge.nodes[i]];
        area += part;
      }
    }
    const double now = sum / area;
    if (at == 0 && now <= limit) at = then + (run.state.time - then) * (before - limit) / (before - now);
    before = now, then = run.state.time;
  }
};

/// By how much the end of the first stage is off where it ends by that temperature, relative to a run without the
/// condition by steps a thirtieth as long.
double error_of_end(Scene scene, double limit) {
  Scene fine = scene;
  fine.accuracy.max_step *= 0.03;
  fine.accuracy.temperature_tolerance *= 0.1;
  Crossing crossing(limit);
  run(fine, {&crossing});
  EXPECT_GT(crossing.at, 0) << limit;
  scene.stages[0].ends.push_back({EndCondition::Kind::surface_below, limit});
  const RunOutcome outcome = run(scene);
  EXPECT_EQ(outcome.facts.stages[0].end_reason, "surface below its temperature") << limit;
  return std::abs(outcome.facts.stages[0].end / crossing.at - 1);
}

TEST(StageEnd, a_step_is_repeated_up_to_where_a_condition_begins_to_hold) {
  for (const double limit : {1258.15, 1248.15, 1233.15}) EXPECT_LT(error_of_end(scene_of(small_scene), limit), 0.03);
  const Scene heat = read_scene(std::string(PARISON_SOURCE_DIR) + "/tests/bars/scenes/half_spaces.toml", "draft");
  for (const double limit : {1340.0, 1325.0, 1315.0}) EXPECT_LT(error_of_end(heat, limit), 0.03) << "heat alone";
}

TEST(StageEnd, mistakes_have_their_sentences) {
  const auto with = [](const std::string& stage, const std::string& keys) {
    const auto text = complaint_about(replaced(stage, stage + "end = { " + keys + " }\n"));
    return text.substr(text.find(' ') + 1);
  };
  const std::string rest = "duration = \"1 s\"\n", or_else = ", allowed is another condition or the duration alone";
  EXPECT_EQ(with(rest, "lowest = \"3 mm\""),
            "stage.end.lowest: the stage has no gravity, which says what is low" + or_else);
  EXPECT_EQ(with(pressed, "filled = \"120 %\""),
            "stage.end.filled: a share of 1.2 was found, allowed are shares up to 100 %");
  EXPECT_EQ(with(pressed, "within = \"1 mm\""),
            "stage.end.within: a distance was found, allowed only together with \"filled\"");
  EXPECT_EQ(with(pressed, "force = \"1 mm\""),
            "stage.end.force: \"1 mm\" is a length, allowed is a force such as \"8 kN\"");
  EXPECT_EQ(with(pressed, ""),
            "stage.end: no condition was found, allowed are force, filled, surface_below, surface_above, lowest");
  EXPECT_EQ(with(pressed, "surface_under = \"1 K\"").rfind("stage.end.surface_under: unknown key", 0), 0u);
}

}  // namespace
}  // namespace parison::forming
