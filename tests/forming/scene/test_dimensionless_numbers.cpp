// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../scene_text.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"

namespace parison::forming {
namespace {

Scene case_of(const std::string& name) {
  return read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/" + name, "draft");
}

/// The line of a text that has a word.
std::string line_with(const std::string& text, const std::string& word) {
  const auto at = text.find(word);
  if (at == text.npos) return {};
  const auto begin = text.rfind('\n', at) + 1;
  return text.substr(begin, text.find('\n', at) - begin);
}

TEST(DimensionlessNumbers, a_shells_numbers_are_those_of_its_thickness_and_pressure) {
  const DimensionlessNumbers numbers = dimensionless_numbers(case_of("shell_inflation"));
  EXPECT_NEAR(numbers.length, 5e-3, 1e-12);
  EXPECT_NEAR(*numbers.speed, 1e5 * 5e-3 / 1e4, 1e-12);
  EXPECT_NEAR(*numbers.reynolds, 2400 * 0.05 * 5e-3 / 1e4, 1e-15);
  EXPECT_FALSE(numbers.capillary || numbers.peclet || numbers.biot || numbers.brinkman);
}

TEST(DimensionlessNumbers, heat_alone_has_only_a_biot_number) {
  const DimensionlessNumbers numbers = dimensionless_numbers(case_of("contact_cylinders"));
  EXPECT_NEAR(*numbers.biot, 5000 * (2 * 400e-6 / 60e-3) / 2.77, 1e-9);
  EXPECT_FALSE(numbers.speed || numbers.reynolds || numbers.capillary || numbers.peclet || numbers.brinkman);
}

TEST(DimensionlessNumbers, a_tools_speed_limit_sets_the_speed) {
  const DimensionlessNumbers numbers = dimensionless_numbers(scene_of(small_scene));
  EXPECT_EQ(*numbers.speed, 0.01);
  const double length = 2 * 200e-6 / 50e-3;
  EXPECT_NEAR(*numbers.peclet, 0.01 * length * 2400 * 1300 / 1.3, 1e-9);
  EXPECT_NEAR(*numbers.brinkman, 1e4 * 0.01 * 0.01 / (1.3 * 600), 1e-12);
}

TEST(DimensionlessNumbers, a_settle_blow_drives_glass_as_through_a_pipe_and_not_as_if_nothing_held_it) {
  const Scene scene = case_of("bottle");
  const DimensionlessNumbers numbers = dimensionless_numbers(scene);
  EXPECT_GT(*numbers.speed, 0.02);
  EXPECT_LT(*numbers.speed, 0.3) << "a run of it moves with up to 0.1 m/s";
  EXPECT_LT(*numbers.reynolds, 0.05);
}

TEST(DimensionlessNumbers, physics_that_is_off_says_why) {
  const std::string heat = describe_scene(case_of("contact_cylinders"));
  EXPECT_EQ(line_with(heat, "  flow "), "  flow                off  the glass's material has no viscosity");
  EXPECT_EQ(line_with(heat, "  Reynolds"), "  Reynolds            n/a         inertia over viscous stress");
  const std::string flow = describe_scene(case_of("shell_inflation"));
  EXPECT_EQ(line_with(flow, "  heat "),
            "  heat                off  the glass's material has no heat capacity and conductivity");
  EXPECT_EQ(line_with(flow, "contact with"), "  contact with tools  off  the scene has no tools");
  EXPECT_EQ(line_with(flow, "air pressure"), "  air pressure        on   in inflation");
  EXPECT_EQ(line_with(flow, "trapped air"), "  trapped air         off  cavities are vented");
}

TEST(DimensionlessNumbers, glass_that_does_not_flow_has_no_inertia_and_no_emissivity_is_not_named) {
  const std::string heat = describe_scene(case_of("contact_cylinders"));
  EXPECT_EQ(line_with(heat, "  inertia"), "  inertia             off  the glass does not flow");
  const std::string flow = describe_scene(case_of("shell_inflation"));
  EXPECT_EQ(line_with(flow, "  inertia"), "  inertia             off  neglected: see the Reynolds number");
  const std::string air = "air = { temperature = \"50 degC\", h = \"20 W/m2/K\", ambient = \"50 degC\" }\n";
  const auto blown = replaced("[material.soft]", air + "[material.soft]");
  EXPECT_EQ(line_with(describe_scene(scene_of(blown)), "  air and"), "  air and radiation   on   air in rest, press");
  const auto radiating = replaced("[material.iron]", "emissivity = 0.9\n[material.iron]", blown);
  EXPECT_EQ(line_with(describe_scene(scene_of(radiating)), "  air and"),
            "  air and radiation   on   air in rest, press, emissivity 0.9");
}

TEST(DimensionlessNumbers, stages_tools_and_accuracy_are_listed) {
  const std::string text = describe_scene(scene_of(small_scene));
  EXPECT_EQ(line_with(text, "  press      "), "  press               2 s; plate, plunger (-5 N, at most 10 mm/s)");
  const std::string overridden =
      describe_scene(scene_of(small_scene + "[numerics]\ntemperature_tolerance = \"0.02 K\"\n"));
  EXPECT_EQ(line_with(overridden, "temperature_tolerance"), "  temperature_tolerance   0.02 K      case");
}

/// L = 200 mm2/25 mm: 1e4 Pa.s over a layer of 4 mm is as stiff as a friction of 2.5e6 Pa.s/m.
TEST(FrictionLines, tell_stick_from_slip_by_the_shear_of_hot_glass) {
  const auto meaning = [](const std::string& coefficient) {
    const std::string text = describe_scene(scene_of(
        replaced("friction = \"slip\"", "friction = { law = \"navier\", coefficient = \"" + coefficient + "\" }")));
    const auto at = text.find("  plunger             ", text.find("\nfriction ("));
    return text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_NE(meaning("1e8 Pa.s/m").find("acts as stick"), std::string::npos) << meaning("1e8 Pa.s/m");
  EXPECT_NE(meaning("2.5e6 Pa.s/m").find("hot glass slides at 50.0 % of the speed of free slip: slides and drags"),
            std::string::npos)
      << meaning("2.5e6 Pa.s/m");
  EXPECT_NE(meaning("1e3 Pa.s/m").find("acts as slip"), std::string::npos) << meaning("1e3 Pa.s/m");
  EXPECT_NE(meaning("1e6 Pa.s/m").find("0.1 bar at 0.01 m/s"), std::string::npos) << meaning("1e6 Pa.s/m");
  EXPECT_EQ(describe_scene(scene_of(small_scene)).find("\nfriction ("), std::string::npos);
}

TEST(DescribeScene, a_force_of_a_thousand_newtons_is_given_in_kilonewtons) {
  const std::string text = describe_scene(read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/tumbler", "draft"));
  EXPECT_NE(text.find("plunger (-10 kN, at most 150 mm/s)"), text.npos) << text;
  EXPECT_NE(text.find("plunger (-300 N, at most 150 mm/s)"), text.npos) << text;
}

}  // namespace
}  // namespace parison::forming
