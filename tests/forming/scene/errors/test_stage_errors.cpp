// SPDX-License-Identifier: GPL-3.0-or-later
// Mistakes in stages: their tools, motions, loads and air.
#include <gtest/gtest.h>

#include "scene_complaint.hpp"

namespace parison::forming {
namespace {

TEST(SceneErrors, stage_naming_an_absent_tool) {
  expect_complaint("tools = [\"plate\", \"plunger\"]\nmotion", "tools = [\"plate\", \"plungr\"]\nmotion",
                   "stage.tools: \"plungr\" was found (did you mean \"plunger\"?), allowed are plate, plunger");
}

TEST(SceneErrors, motion_of_a_tool_that_is_not_active) {
  const auto text = replaced("tools = [\"plate\", \"plunger\"]\nmotion", "tools = [\"plate\"]\nmotion");
  EXPECT_EQ(complaint_about(text),
            std::to_string(line_of("motion.plunger")) +
                ": stage.motion.plunger: a motion of \"plunger\", which is not active in this stage, "
                "allowed are the stage's tools: plate");
}

TEST(SceneErrors, pressure_on_an_unknown_boundary) {
  expect_complaint("pressure.surface", "pressure.surfaces",
                   "stage.pressure.surfaces: \"surfaces\" was found (did you mean \"surface\"?), allowed are surface");
  expect_complaint("pressure.surface", "pressure.axis", "stage.pressure.axis: \"axis\" was found, allowed are surface");
}

TEST(SceneErrors, a_named_boundary_counts_from_its_stage_on) {
  const std::string named = "name_boundary = [{ name = \"inner\", from = \"(0, 10) mm\", to = \"(20, 10) mm\" }]\n";
  const auto late = replaced("duration = \"1 s\"\n", "duration = \"1 s\"\npressure.inner = \"1 bar\"\n",
                             replaced("gravity", named + "gravity"));
  EXPECT_EQ(complaint_about(late).rfind(
                std::to_string(line_of("pressure.inner", late)) + ": stage.pressure.inner: \"inner\" was found", 0),
            0u);
  EXPECT_EQ(complaint_about(replaced("pressure.surface", "pressure.inner",
                                     replaced("duration = \"1 s\"\n", "duration = \"1 s\"\n" + named))),
            "");
}

TEST(SceneErrors, glass_and_tool_that_can_touch_without_an_interface) {
  const auto text = replaced("tools = [\"plate\", \"plunger\"]\nlaw", "tools = [\"plate\"]\nlaw");
  const auto stage = text.rfind("[[stage]]");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(stage), '\n');
  EXPECT_EQ(complaint_about(text), std::to_string(line) +
                                       ": stage.tools: the glass and \"plunger\" can touch in stage \"press\" but have "
                                       "no interface; allowed is an [[interface]] that names the tool");
}

TEST(SceneErrors, open_surfaces_that_radiate_need_air) {
  const auto text = replaced("[material.iron]", "emissivity = 0.9\n[material.iron]");
  EXPECT_EQ(complaint_about(text),
            std::to_string(line_of("[[stage]]", text)) +
                ": stage.air: missing, but \"glass\" exchanges heat with the air; allowed is [air] "
                "for the case or air in each stage");
}

TEST(SceneErrors, loads_on_glass_that_does_not_flow) {
  const auto text = replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }\n", "");
  EXPECT_EQ(
      complaint_about(text).rfind(std::to_string(line_of("motion.plunger", text)) + ": stage.motion.plunger.force", 0),
      0u);
}

TEST(SceneErrors, a_boundary_is_named_once) {
  const std::string named = "{ name = \"inner\", from = \"(0, 10) mm\", to = \"(20, 10) mm\" }";
  const std::string one = "duration = \"1 s\"\n", two = "duration = \"2 s\"\n";
  const auto twice = replaced(one, one + "name_boundary = [" + named + ",\n" + named + "]\n");
  EXPECT_NE(complaint_about(twice).find("\"inner\" was found twice"), std::string::npos);
  const auto later = replaced(one, one + "name_boundary = [" + named + "]\n",
                              replaced(two, two + "name_boundary = [" + named + "]\n"));
  EXPECT_NE(complaint_about(later).find("stage \"rest\" names \"inner\" already"), std::string::npos);
}

TEST(SceneErrors, a_force_of_zero) {
  expect_complaint("force = \"-5 N\"", "force = \"0 N\"",
                   "stage.motion.plunger.force: \"0 N\" was found, allowed is a force other than zero");
}

TEST(SceneErrors, a_tool_that_is_not_active_is_in_the_air_too) {
  const auto message = complaint_about(replaced("path = \"(15, 20) (0, 20) mm\", condition = \"insulated\"",
                                                "path = \"(15, 20) (0, 20) mm\", condition = \"air\""));
  EXPECT_EQ(
      message,
      std::to_string(line_of("[[stage]]\nname = \"rest\"")) +
          ": stage.air: missing, but \"plunger\" exchanges heat with the air; allowed is [air] for the case or air in "
          "each stage");
}

TEST(SceneErrors, more_tools_driven_by_forces_than_a_stage_bears) {
  std::string text = small_scene, tools, place, motions;
  for (int i = 0; i < 4; ++i) {
    const std::string name = "p" + std::to_string(i), low = std::to_string(40 + 10 * i),
                      high = std::to_string(45 + 10 * i);
    tools += "[[tool]]\nname = \"" + name +
             "\"\nmaterial = \"iron\"\ntemperature = \"400 degC\"\nfriction = \"slip\"\nboundary = [\n" +
             "{ name = \"face\", path = \"(0, " + low + ") (15, " + low + ") mm\", condition = \"contact\" },\n" +
             "{ name = \"rest\", path = \"(15, " + high + ") (0, " + high + ") mm\", condition = \"insulated\" },\n" +
             "{ name = \"axis\", path = \"(0, " + low + ") mm\", condition = \"symmetry\" },\n]\n";
    place += ", \"" + name + "\"";
    motions += "motion." + name + " = { force = \"-5 N\", speed_limit = \"10 mm/s\" }\n";
  }
  text = replaced("[[interface]]\ntools = [\"plate\", \"plunger\"",
                  tools + "[[interface]]\ntools = [\"plate\", \"plunger\"" + place, text);
  text = replaced("tools = [\"plate\", \"plunger\"]\nmotion",
                  "tools = [\"plate\", \"plunger\"" + place + "]\n" + motions + "motion", text);
  const auto message = complaint_about(text);
  EXPECT_NE(message.find("too many tools driven by a force were found, allowed are 4 in a stage"), message.npos)
      << message;
}

TEST(SceneErrors, trapped_air_with_another_law_or_without_its_temperature) {
  const auto with = [](const std::string& air) { return complaint_about("trapped_air = " + air + "\n" + small_scene); };
  EXPECT_EQ(with(R"({ law = "adiabatic", temperature = "500 degC", vent_area = "2 mm2", seal_gap = "0.2 mm" })"), "");
  EXPECT_EQ(with(R"({ law = "vented" })"), "");
  EXPECT_NE(with(R"({ law = "isotherm", temperature = "500 degC" })").find("isothermal"), std::string::npos);
  EXPECT_NE(with(R"({ law = "isothermal" })").find("trapped_air.temperature"), std::string::npos);
  EXPECT_NE(with(R"({ law = "vented", vent_area = "2 mm2" })").find("found with the law \"vented\""),
            std::string::npos);
  EXPECT_NE(with(R"({ law = "isothermal", temperature = "500 degC", vent_area = "2 mm" })").find("is a length"),
            std::string::npos);
}

TEST(SceneErrors, a_motion_that_starts_away_from_its_tool) {
  const std::string moved = replaced("motion.plunger = { force = \"-5 N\", speed_limit = \"10 mm/s\" }",
                                     "motion.plunger = { offset = [[\"0 s\", \"12 mm\"], [\"1 s\", \"9 mm\"]] }");
  const auto message = complaint_about(moved);
  EXPECT_NE(message.find("stage.motion.plunger: starts at 12 mm, but the tool is at 10 mm then"), message.npos)
      << message;
  EXPECT_EQ(complaint_about(replaced("\"12 mm\"", "\"10 mm\"", moved)), "");
}

}  // namespace
}  // namespace parison::forming
