// SPDX-License-Identifier: GPL-3.0-or-later
// Mistakes in tools that are not round, and in stages in which the glass is a body in space.
#include <gtest/gtest.h>

#include "scene_complaint.hpp"

namespace parison::forming {
namespace {

const std::string square_jar = std::string(PARISON_SOURCE_DIR) + "/cases/square_jar/case.toml";

/// What is said of the bundled square jar with values replaced; empty where it is taken.
std::string complaint_about_jar(const std::vector<std::string>& overrides) {
  try {
    read_scene(square_jar, "draft", overrides);
  } catch (const core::CaseError& error) {
    return error.what();
  }
  return "";
}

void expect_part(const std::string& override_text, const std::string& part) {
  const std::string complaint = complaint_about_jar({override_text});
  EXPECT_NE(complaint.find(part), std::string::npos) << override_text << ": " << complaint;
}

TEST(SolidErrors, the_bundled_square_jar_is_taken) {
  EXPECT_EQ(complaint_about_jar({}), "");
}

TEST(SolidErrors, sections_that_no_glass_can_have) {
  expect_part("tool.blow_mould.section.corner_radius=\"33 mm\"",
              "a corner radius of 33 mm was found, allowed are at most 31.5 mm");
  expect_part("tool.blow_mould.section={ exponent = 1.5 }", "an exponent of 1.5 was found, allowed are 2");
  expect_part("tool.blow_mould.section={ exponent = 3, corner_radius = \"12 mm\" }", "allowed is one of them");
  expect_part("tool.blow_mould.section={ half_depth = [[\"200 mm\", \"30 mm\"]] }",
              "z = 200 mm was found, allowed are heights of the contact boundaries of \"blow_mould\"");
}

TEST(SolidErrors, sectors_that_are_no_symmetry) {
  expect_part("stage.reheat.solid.sector=\"100 deg\"", "100 deg was found, allowed is a whole part of 360 deg");
  expect_part("stage.reheat.solid.sector=\"45 deg\"", "a sector of 45 deg was found, allowed are 90, 180 and 360 deg");
}

TEST(SolidErrors, tools_that_are_not_round_around_round_glass) {
  expect_part("tool.blank.section={ corner_radius = \"12 mm\" }",
              "\"blank\" is not round, allowed are such tools from");
}

TEST(SolidErrors, a_mould_narrower_than_the_blank_in_one_direction) {
  expect_part("tool.blow_mould.section={ half_depth = [[\"40 mm\", \"22 mm\"]], exponent = 4 }", "\"blank\" is");
  expect_part("tool.blow_mould.section={ half_depth = [[\"40 mm\", \"22 mm\"]], exponent = 4 }",
              "90 deg from the plane y = 0");
}

TEST(SolidErrors, what_round_stages_have_is_taken_in_space_too) {
  for (const char* text :
       {"stage.blow.end={ filled = \"99 %\" }",
        "interface.0={ tools = [\"ring\", \"plate\", \"blank\", \"plunger\", \"blow_mould\"], law = \"gap\" }",
        "tool.blow_mould.friction={ law = \"navier\", coefficient = \"1e8 Pa.s/m\", coulomb = 0.3 }",
        "material.flint.shear_thinning={ time = \"1 ms\", exponent = 0.5 }"})
    EXPECT_EQ(complaint_about_jar({text}), "") << text;
}

TEST(SolidErrors, what_is_not_computed_in_space_is_named) {
  expect_part("stage.reheat.motion.ring={ force = \"1 N\", speed_limit = \"1 mm/s\" }",
              "a tool that a force drives was found");
  expect_part("stage.blow.end={ force = \"1 kN\" }", "a force that ends the stage was found");
  expect_part("stage.hold.trapped_air={ law = \"isothermal\", temperature = \"500 degC\" }", "trapped air was found");
}

}  // namespace
}  // namespace parison::forming
