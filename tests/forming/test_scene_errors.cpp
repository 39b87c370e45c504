// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "scene_text.hpp"

namespace parison::forming {
namespace {

/// Replaces a piece of the small scene and expects the complaint to start at the changed line.
void expect_complaint(const std::string& from, const std::string& to, const std::string& rest) {
  EXPECT_EQ(complaint_about(replaced(from, to)), std::to_string(line_of(from)) + ": " + rest);
}

TEST(SceneErrors, TheSmallSceneItselfIsFine) {
  EXPECT_EQ(complaint_about(small_scene), "");
}

TEST(SceneErrors, UnknownKey) {
  expect_complaint("duration = \"2 s\"", "duraton = \"2 s\"",
                   "stage.duraton: unknown key (did you mean \"duration\"?), allowed are name, duration, end_speed, "
                   "gravity, tools, motion, pressure, air, name_piece");
}

TEST(SceneErrors, WrongUnit) {
  expect_complaint("duration = \"2 s\"", "duration = \"2 mm\"",
                   "stage.duration: \"2 mm\" is a length, allowed is a time such as \"0.9 s\"");
}

TEST(SceneErrors, MissingCsvFile) {
  const auto message = complaint_about(replaced("path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"", "csv = \"none.csv\""));
  EXPECT_EQ(message.rfind(std::to_string(line_of("(0, 0) (20, 0)")) + ": glass.piece.csv: no file \"", 0), 0u)
      << message;
  EXPECT_NE(message.find("none.csv\", allowed is a CSV file beside the case file"), std::string::npos) << message;
}

TEST(SceneErrors, MissingCaseFile) {
  EXPECT_THROW(read_scene("no/such/case", "draft"), core::CaseError);
}

TEST(SceneErrors, SelfCrossingProfile) {
  expect_complaint(
      "{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"",
      "{ name = \"surface\", path = \"(0, 0) (20, 10) (20, 0) (0, 10) mm\"",
      "glass.piece: the outline crosses itself (piece \"surface\" meets piece \"surface\" beside (0, 0) mm), "
      "allowed is an outline that meets itself nowhere");
}

TEST(SceneErrors, ProfileBeyondTheAxis) {
  expect_complaint("{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"",
                   "{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (-1, 10) mm\"",
                   "glass.piece: (-1, 10) mm lies beyond the axis, allowed are radii from zero");
}

TEST(SceneErrors, ToolOverlappingTheGlassAtTheStart) {
  const auto message = complaint_about(replaced("(30, 0) (0, 0) mm", "(30, 1) (0, 1) mm"));
  const auto expected =
      std::to_string(line_of("[[tool]]")) + ": tool: \"plate\" overlaps the glass at the start by 1 mm, ";
  EXPECT_EQ(message.substr(0, expected.size()), expected);
  EXPECT_EQ(complaint_about(replaced("(30, 0) (0, 0) mm", "(30, 0.0009) (0, 0.0009) mm")), "");
}

TEST(SceneErrors, ToolInsideTheGlassIsFoundByItsOwnPoints) {
  const auto pin = replaced("(30, 0) (0, 0) mm", "(1, 0) (0.01, 3) (0, 3) mm",
                            replaced("(0, -10) (30, -10) mm", "(0, -10) (1, -10) mm"));
  EXPECT_EQ(complaint_about(pin).rfind(std::to_string(line_of("[[tool]]")) + ": tool: \"plate\" overlaps", 0), 0u);
}

TEST(SceneErrors, AToolThatIsAbsentFromTheFirstStageMayOverlap) {
  EXPECT_EQ(complaint_about(replaced("position = \"10 mm\"", "position = \"5 mm\"")), "");
}

TEST(SceneErrors, StageNamingAnAbsentTool) {
  expect_complaint("tools = [\"plate\", \"plunger\"]\nmotion", "tools = [\"plate\", \"plungr\"]\nmotion",
                   "stage.tools: \"plungr\" was found (did you mean \"plunger\"?), allowed are plate, plunger");
}

TEST(SceneErrors, MotionOfAToolNotInPlace) {
  const auto text = replaced("tools = [\"plate\", \"plunger\"]\nmotion", "tools = [\"plate\"]\nmotion");
  EXPECT_EQ(complaint_about(text), std::to_string(line_of("motion.plunger")) +
                                       ": stage.motion.plunger: a motion of \"plunger\", which is not in place, "
                                       "allowed are the stage's tools: plate");
}

TEST(SceneErrors, PressureOnAnUnknownPiece) {
  expect_complaint("pressure.surface", "pressure.surfaces",
                   "stage.pressure.surfaces: \"surfaces\" was found (did you mean \"surface\"?), allowed are surface");
  expect_complaint("pressure.surface", "pressure.axis", "stage.pressure.axis: \"axis\" was found, allowed are surface");
}

TEST(SceneErrors, ANamedStretchCountsFromItsStageOn) {
  const std::string stretch = "name_piece = [{ name = \"inner\", from = \"(0, 10) mm\", to = \"(20, 10) mm\" }]\n";
  const auto late = replaced("duration = \"1 s\"\n", "duration = \"1 s\"\npressure.inner = \"1 bar\"\n",
                             replaced("gravity", stretch + "gravity"));
  EXPECT_EQ(complaint_about(late).rfind(
                std::to_string(line_of("pressure.inner", late)) + ": stage.pressure.inner: \"inner\" was found", 0),
            0u);
  EXPECT_EQ(complaint_about(replaced("pressure.surface", "pressure.inner",
                                     replaced("duration = \"1 s\"\n", "duration = \"1 s\"\n" + stretch))),
            "");
}

TEST(SceneErrors, NegativeProperties) {
  expect_complaint("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }",
                   "viscosity = { law = \"constant\", value = \"-1e4 Pa.s\" }",
                   "material.soft.viscosity.value: \"-1e4 Pa.s\" was found, allowed is a viscosity such as "
                   "\"1e4 Pa.s\", above zero");
  expect_complaint(
      "density = \"7200 kg/m3\"", "density = \"-7200 kg/m3\"",
      "material.iron.density: \"-7200 kg/m3\" was found, allowed is a density such as \"2400 kg/m3\", above "
      "zero");
  expect_complaint("conductivity = \"46 W/m/K\"", "conductivity = [[\"20 degC\", \"-46 W/m/K\"]]",
                   "material.iron.conductivity: -46 was found, allowed are values above zero");
  expect_complaint("h = \"2000 W/m2/K\"", "h = \"-2000 W/m2/K\"",
                   "interface.h: \"-2000 W/m2/K\" was found, allowed is a heat transfer coefficient such as "
                   "\"5000 W/m2/K\", above zero");
}

TEST(SceneErrors, GlassAndToolThatCanTouchWithoutAnInterface) {
  const auto text = replaced("tools = [\"plate\", \"plunger\"]\nlaw", "tools = [\"plate\"]\nlaw");
  const auto stage = text.rfind("[[stage]]");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(stage), '\n');
  EXPECT_EQ(complaint_about(text), std::to_string(line) +
                                       ": stage.tools: the glass and \"plunger\" can touch in stage \"press\" but have "
                                       "no interface; allowed is an [[interface]] that names the tool");
}

TEST(SceneErrors, ProbeOutsideItsBody) {
  expect_complaint("point = \"(0, 5) mm\"", "point = \"(0, 11) mm\"",
                   "probe.point: \"(0, 11) mm\" lies outside \"glass\", allowed are points inside or on its outline");
}

TEST(SceneErrors, OpenSurfacesThatRadiateNeedAir) {
  const auto text = replaced("[material.iron]", "emissivity = 0.9\n[material.iron]");
  EXPECT_EQ(complaint_about(text),
            std::to_string(line_of("[[stage]]", text)) +
                ": stage.air: missing, but \"glass\" exchanges heat with the air; allowed is [air] "
                "for the case or air in each stage");
}

TEST(SceneErrors, RepeatedNames) {
  expect_complaint("name = \"plunger\"", "name = \"plate\"",
                   "tool.name: \"plate\" was found twice, allowed are different names");
}

TEST(SceneErrors, LoadsOnGlassThatDoesNotFlow) {
  const auto text = replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }\n", "");
  EXPECT_EQ(
      complaint_about(text).rfind(std::to_string(line_of("motion.plunger", text)) + ": stage.motion.plunger.force", 0),
      0u);
}

TEST(SceneErrors, TextThatIsNoPath) {
  expect_complaint("(0, 0) (20, 0) (20, 10) (0, 10) mm", "(0, 0) (20) mm",
                   "glass.piece.path: \"(20)\" has 1 coordinates, allowed are 2");
  const auto message = complaint_about(replaced("(0, 0) (20, 0) (20, 10) (0, 10) mm", "0, 0 to 20, 0"));
  EXPECT_NE(message.find("glass.piece.path: \"0, 0 to 20, 0\" was found, allowed are points such as"),
            std::string::npos);
}

}  // namespace
}  // namespace parison::forming
