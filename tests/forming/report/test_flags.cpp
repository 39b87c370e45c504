// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/diagnostics/extremes.hpp"
#include "forming/report/process/flags.hpp"
#include "forming/report/process/mould_filling.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/tool_surface.hpp"

namespace parison::forming {
namespace {

constexpr double zero = 273.15;  // degC in K

/// The small scene after steps of 0.1 s, or as long, in which the plunger's rim has these temperatures, degC, and glass
/// touches it in the first of them.
Extremes after(const Scene& scene, const std::vector<double>& temperatures, int touching = 100, double step = 0.1) {
  Extremes extremes;
  State before = initial_state(scene);
  for (const double temperature : temperatures) {
    State state = before;
    state.time += step;
    state.glass.contact_tool.assign(state.glass.mesh.nodes.size(), touching-- > 0 ? 1 : -1);
    ToolState& plunger = state.tools[1];
    for (Index n = 0; n < plunger.mesh.node_count(); ++n)
      if (plunger.mesh.nodes[n][0] > 0.0149 && plunger.mesh.nodes[n][1] < 1e-9)
        plunger.temperature[n] = zero + temperature;
    follow_extremes(scene, before, state, extremes);
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
  EXPECT_EQ(flags[0].sentence,
            "plunger surface 700 degC at (15.0, 10.0) mm at 0.30 s, above 645 degC for 0.30 s in which glass touched "
            "it: glass may "
            "stick; cool the tool more or shorten the contact");
  EXPECT_TRUE(raised_flags(scene, after(scene, {600, 640}), 0.2, {}).empty());
}

TEST(Flags, a_hot_tool_is_told_only_for_the_time_in_which_glass_touches_it) {
  const Scene scene = scene_of(small_scene);
  const FlagsRaised flags = raised_flags(scene, after(scene, {700, 690, 680, 670}, 2), 0.4, {});
  ASSERT_EQ(flags.size(), 1u);
  EXPECT_NEAR(flags[0].seconds, 0.2, 1e-12);
  EXPECT_TRUE(raised_flags(scene, after(scene, {700, 690}, 0), 0.2, {}).empty()) << "it has left the glass";
  EXPECT_TRUE(raised_flags(scene, after(scene, {700, 600}, 100, 0.004), 0.008, {}).empty()) << "0.00 s";
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

/// A thimble of glass, 4 mm outside and open above, in a mould of this radius, mm, that ends at a height, mm.
State thimble(double mould_radius, double mould_height, const std::string& pressure, Scene& scene) {
  const auto wall = fmt::format("({0}, {1}) ({0}, 0) (0, 0) mm", mould_radius, mould_height);
  scene = scene_of(R"(case = "thimble"
geometry = "axisymmetric"
[material.soft]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e4 Pa.s" }
[glass]
material = "soft"
boundary = [
  { name = "outer", path = "(0, 0) (4, 0) (4, 20) mm", condition = "contact" },
  { name = "top", path = "(3, 20) mm", condition = "air" },
  { name = "inner", path = "(3, 1) (0, 1) mm", condition = "air" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]
[[tool]]
name = "mould"
friction = "stick"
boundary = [
  { name = "cavity", path = ")" +
                   wall + R"(", condition = "contact" },
  { name = "axis", path = "(0, -5) mm", condition = "symmetry" },
  { name = "outer", path = "(20, -5) (20, )" +
                   fmt::format("{0}) ({1}, {0}) mm", mould_height, mould_radius) + R"(", condition = "insulated" },
]
[[stage]]
name = "blow"
duration = "1 s"
tools = ["mould"]
pressure.inner = )" +
                   pressure + "\n");
  return initial_state(scene);
}

TEST(Flags, glass_blown_into_a_mould_that_is_not_full_is_told_however_far_it_is_from_it) {
  Scene scene;
  const State state = thimble(6, 20, "\"1 bar\"", scene);
  const MouldFilling filling = mould_filling(scene, state);
  ASSERT_TRUE(filling.was_blown());
  EXPECT_GT(filling.share, 16. / (16 + 2 * 4 * 20)) << "the bottom";
  EXPECT_LT(filling.share, 16. / (16 + 2 * 4 * 20) + 0.03) << "and what is 0.2 mm above it";
  EXPECT_NEAR(filling.largest_gap, 2e-3, 1e-9);
  EXPECT_NEAR(filling.at[0], 4e-3, 1e-9) << "the side; the rim faces no tool and is none of the places";
  const auto flag = mould_not_filled(filling);
  ASSERT_TRUE(flag);
  EXPECT_EQ(flag->name, "mould_not_filled");
  EXPECT_NE(flag->sentence.find("of the outer surface that faces a tool"), std::string::npos) << flag->sentence;
  EXPECT_NE(flag->sentence.find("mm is 2 mm away"), std::string::npos) << flag->sentence;
  const State in_touch = thimble(4.1, 20, "[[\"0 s\", \"0 bar\"], [\"1 s\", \"1 bar\"]]", scene);
  const MouldFilling full = mould_filling(scene, in_touch);
  EXPECT_TRUE(full.was_blown());
  EXPECT_FALSE(mould_not_filled(full));
}

TEST(Flags, glass_that_no_pressure_blows_or_that_no_mould_surrounds_is_not_told_as_unfilled) {
  Scene scene;
  const State pressed = thimble(6, 20, "\"0 bar\"", scene);
  EXPECT_FALSE(mould_filling(scene, pressed).was_blown()) << "nothing is blown";
  const State free = thimble(6, 3, "\"1 bar\"", scene);
  EXPECT_FALSE(mould_filling(scene, free).was_blown()) << "most of it has no tool in front";
  EXPECT_FALSE(mould_not_filled(MouldFilling{}));
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
