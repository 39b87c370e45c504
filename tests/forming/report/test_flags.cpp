// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/report/process/flags.hpp"
#include "forming/report/process/glass_shape.hpp"
#include "forming/report/process/tool_surface.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {
namespace {

constexpr double zero = 273.15;  // degC in K

/// The small scene after steps of 0.1 s in which the plunger's rim has these temperatures, degC.
Extremes after(const Scene& scene, const std::vector<double>& temperatures) {
  Extremes extremes;
  State before = initial_state(scene);
  for (const double temperature : temperatures) {
    State state = before;
    state.time += 0.1;
    ToolState& plunger = state.tools[1];
    for (Index n = 0; n < plunger.mesh.node_count(); ++n)
      if (plunger.mesh.nodes[n][0] > 0.0149 && plunger.mesh.nodes[n][1] < 1e-9)
        plunger.temperature[n] = zero + temperature;
    update_extremes(scene, before, state, extremes);
    before = state;
  }
  return extremes;
}

TEST(Extremes, the_hottest_place_and_time_of_a_tool_and_how_long_it_was_beyond_its_limit_are_kept) {
  const Scene scene = scene_of(small_scene);
  const Extremes extremes = after(scene, {600, 650, 700, 660, 640});
  const Extreme& plunger = extremes.tools.at(1);
  EXPECT_NEAR(plunger.temperature, zero + 700, 1e-9);
  EXPECT_NEAR(plunger.time, 0.3, 1e-12);
  EXPECT_NEAR(plunger.at[0], 0.015, 1e-9);
  EXPECT_NEAR(plunger.at[1], 0.010, 1e-9);
  EXPECT_NEAR(plunger.first_beyond, 0.2, 1e-12);
  EXPECT_NEAR(plunger.seconds_beyond, 0.3, 1e-12);
  EXPECT_FALSE(extremes.tools.at(0).was_beyond());
}

TEST(Flags, a_tool_hotter_than_the_sticking_temperature_is_told_with_place_time_and_what_to_do) {
  Scene scene = scene_of(small_scene);
  EXPECT_NEAR(scene.output.flags.tool_surface_above, zero + 645, 1e-9);
  const Extremes extremes = after(scene, {600, 650, 700, 660, 640});
  FlagsRaised flags = raised_flags(scene, extremes, 0.5, {});
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_EQ(flags[0].name, "tool_surface_above");
  EXPECT_EQ(flags[0].tool, "plunger");
  EXPECT_NEAR(flags[0].value, 700, 1e-9);
  EXPECT_EQ(
      flags[0].sentence,
      "plunger surface 700 degC at (15.0, 10.0) mm at 0.30 s, above 645 degC for 0.30 s: glass may stick; cool the "
      "tool more or shorten the contact");
  EXPECT_TRUE(raised_flags(scene, after(scene, {600, 640}), 0.2, {}).empty());
}

TEST(Flags, cold_glass_and_a_thin_wall_are_told_where_the_case_has_a_limit) {
  Scene scene = scene_of(small_scene);
  const ThicknessRange wall{1e-3, 2e-3, 3e-3, Point(0.02, 0.01), Point(0, 0)};
  EXPECT_TRUE(raised_flags(scene, after(scene, {500}), 0.1, wall).empty());
  scene.output.flags.glass_below = zero + 1001;
  scene.output.flags.wall_below = 1.2e-3;
  const FlagsRaised flags = raised_flags(scene, after(scene, {500}), 0.1, wall);
  ASSERT_EQ(flags.size(), 2u);
  EXPECT_EQ(flags[0].name, "glass_below");
  EXPECT_NEAR(flags[0].value, 1000, 1e-9);
  EXPECT_EQ(flags[1].name, "wall_below");
  EXPECT_NE(flags[1].sentence.find("wall 1.00 mm at (20.0, 10.0) mm, below 1.20 mm"), std::string::npos);
}

TEST(Flags, glass_blown_into_a_mould_that_is_not_full_is_told_with_the_place_furthest_from_it) {
  const auto flag_of = [](const Stage& stage, double share) {
    return mould_not_filled(stage, {share, 2.5e-3, Point(0.03, 0.12)}, 4);
  };
  Stage stage;
  EXPECT_FALSE(flag_of(stage, 0.91)) << "nothing blows";
  stage.pressure.emplace("inner", core::TimeFunction{});
  const auto flag = flag_of(stage, 0.91);
  ASSERT_TRUE(flag);
  EXPECT_EQ(flag->name, "mould_not_filled");
  EXPECT_NEAR(flag->value, 91, 1e-9);
  EXPECT_NE(flag->sentence.find("91.0 % of the outer surface"), std::string::npos) << flag->sentence;
  EXPECT_NE(flag->sentence.find("(30.0, 120.0) mm is 2.5 mm away"), std::string::npos) << flag->sentence;
  EXPECT_FALSE(flag_of(stage, 0.99)) << "full";
  EXPECT_FALSE(flag_of(stage, 0.2)) << "blown freely from a ring";
}

TEST(Flags, the_limits_are_read_from_the_case) {
  const Scene scene = scene_of(small_scene +
                               "[output]\nflags = { tool_surface_above = \"600 degC\", glass_below = "
                               "\"550 degC\", wall_below = \"1.5 mm\" }\n");
  EXPECT_NEAR(scene.output.flags.tool_surface_above, zero + 600, 1e-9);
  EXPECT_NEAR(*scene.output.flags.glass_below, zero + 550, 1e-9);
  EXPECT_NEAR(*scene.output.flags.wall_below, 1.5e-3, 1e-12);
}

TEST(GlassShape, the_lowest_point_goes_with_gravity) {
  Scene scene = scene_of(small_scene);
  const State state = initial_state(scene);
  scene.stages[0].gravity = -9.81;
  EXPECT_NEAR(lowest_downwards(scene, state), 0, 1e-12);
  EXPECT_EQ(upwards(scene, state), 1);
  scene.stages[0].gravity = 9.81;
  EXPECT_NEAR(lowest_downwards(scene, state), 0.01, 1e-12);
  EXPECT_EQ(upwards(scene, state), -1);
  scene.stages[0].gravity = 0;
  EXPECT_TRUE(std::isnan(lowest_downwards(scene, state)));
}

}  // namespace
}  // namespace parison::forming
