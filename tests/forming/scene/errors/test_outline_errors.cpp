// SPDX-License-Identifier: GPL-3.0-or-later
// Mistakes in outlines and meshes of glass and tools, and in where they are at the start.
#include <gtest/gtest.h>

#include "scene_complaint.hpp"

namespace parison::forming {
namespace {

TEST(SceneErrors, missing_csv_file) {
  const auto message = complaint_about(replaced("path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"", "csv = \"none.csv\""));
  EXPECT_EQ(message.rfind(std::to_string(line_of("(0, 0) (20, 0)")) + ": glass.boundary.csv: no file \"", 0), 0u)
      << message;
  EXPECT_NE(message.find("none.csv\", allowed is a CSV file with its path relative to the case file"),
            std::string::npos)
      << message;
}

TEST(SceneErrors, self_crossing_profile_is_told_with_the_place_of_the_crossing) {
  expect_complaint("{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"",
                   "{ name = \"surface\", path = \"(0, 0) (20, 10) (20, 0) (0, 10) mm\"",
                   "glass.boundary: the outline crosses itself (boundary \"surface\" meets boundary "
                   "\"surface\" near (10, 5) mm), "
                   "allowed is an outline that does not touch itself");
}

TEST(SceneErrors, an_outline_that_goes_back_on_its_own_line) {
  const std::string said = "glass.boundary: the outline encloses no area, allowed is one that leads around a body";
  const auto flat = replaced("(0, 0) (20, 0) (20, 10) (0, 10) mm", "(0, 0) (20, 0) mm");
  EXPECT_NE(complaint_about(flat).find(said), std::string::npos) << complaint_about(flat);
  const auto gob = replaced("[glass]\n", "[glass]\ngob.mass = \"20 g\"\n", flat);
  EXPECT_NE(complaint_about(gob).find(said), std::string::npos) << complaint_about(gob);
}

TEST(SceneErrors, profile_beyond_the_axis) {
  expect_complaint("{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"",
                   "{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (-1, 10) mm\"",
                   "glass.boundary: (-1, 10) mm is on the wrong side of the axis, allowed are radii from zero");
}

TEST(SceneErrors, tool_overlapping_the_glass_at_the_start) {
  const auto message = complaint_about(replaced("(30, 0) (0, 0) mm", "(30, 1) (0, 1) mm"));
  const auto expected =
      std::to_string(line_of("[[tool]]")) + ": tool: \"plate\" overlaps the glass at the start by 1 mm, ";
  EXPECT_EQ(message.substr(0, expected.size()), expected);
  EXPECT_NE(message.find("the glass lies between 0 and 10 mm along the axis"), message.npos) << message;
  EXPECT_EQ(complaint_about(replaced("(30, 0) (0, 0) mm", "(30, 0.0003) (0, 0.0003) mm")), "");
}

TEST(SceneErrors, tool_inside_the_glass_is_found_by_its_own_points) {
  const auto pin = replaced("(30, 0) (0, 0) mm", "(1, 0) (0.01, 3) (0, 3) mm", replaced("(30, -10) mm", "(1, -10) mm"));
  EXPECT_EQ(complaint_about(pin).rfind(std::to_string(line_of("[[tool]]")) + ": tool: \"plate\" overlaps", 0), 0u);
}

TEST(SceneErrors, a_tool_that_is_absent_from_the_first_stage_may_overlap) {
  EXPECT_EQ(complaint_about(replaced("position = \"10 mm\"", "position = \"5 mm\"")), "");
}

TEST(SceneErrors, text_that_is_no_path) {
  expect_complaint("(0, 0) (20, 0) (20, 10) (0, 10) mm", "(0, 0) (20) mm",
                   "glass.boundary.path: \"(20)\" has 1 coordinates, allowed are 2");
  const auto message = complaint_about(replaced("(0, 0) (20, 0) (20, 10) (0, 10) mm", "0, 0 to 20, 0"));
  EXPECT_NE(message.find("glass.boundary.path: \"0, 0 to 20, 0\" was found, allowed are points such as"),
            std::string::npos);
}

TEST(SceneErrors, sizes_that_would_give_too_many_cells) {
  const auto glass = [](const std::string& mesh) {
    return complaint_about(replaced("temperature = \"1000 degC\"", "temperature = \"1000 degC\"\nmesh = " + mesh));
  };
  const auto line = std::to_string(line_of("temperature = \"1000 degC\"") + 1);
  EXPECT_EQ(glass("{ size = \"10 um\" }"), line +
                                               ": glass.mesh.size: 0.01 mm would give \"glass\" about 4.6e+06 cells, "
                                               "allowed are sizes that give up to 500000");
  EXPECT_EQ(glass("{ contact_size = \"1 um\" }"),
            line +
                ": glass.mesh.contact_size: 0.001 mm would give \"glass\" about 6e+04 edges along its outline, allowed "
                "are sizes that give up to 50000");
  EXPECT_EQ(glass("{ size = \"0.1 mm\", contact_size = \"10 um\" }"), "");
  const auto numerics = [](const std::string& entry) {
    const auto message = complaint_about(small_scene + "[numerics]\n" + entry + "\n");
    return message.substr(message.find(' ') + 1, message.find(" would") - message.find(' ') - 1);
  };
  EXPECT_EQ(numerics("surface_size = \"10 um\"\nskin_size = \"10 um\""), "numerics.surface_size: 0.01 mm");
  EXPECT_EQ(numerics("skin_size = \"1 um\""), "numerics.skin_size: 0.001 mm");
  EXPECT_EQ(numerics("tool_contact_size = \"1 um\""), "numerics.tool_contact_size: 0.001 mm");
}

TEST(SceneErrors, a_mapped_mesh_of_too_many_divisions) {
  const auto text = replaced(
      "{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\", condition = \"contact\" }",
      "{ name = \"a\", path = \"(0, 0) (20, 0) mm\", condition = \"contact\" }, { name = \"b\", path = \"(20, 10) "
      "mm\", "
      "condition = \"contact\" }, { name = \"c\", path = \"(0, 10) mm\", condition = \"contact\" }",
      replaced(
          "pressure.surface", "pressure.a",
          replaced("temperature = \"1000 degC\"", "temperature = \"1000 degC\"\nmesh = { mapped = [1000, 1000] }")));
  EXPECT_EQ(complaint_about(text), std::to_string(line_of("mesh", text)) +
                                       ": glass.mesh.mapped: 1000 by 1000 divisions were found, allowed are up to "
                                       "250000 in all");
}

TEST(SceneErrors, a_boundary_along_the_axis_is_a_symmetry) {
  expect_complaint("{ name = \"axis\", path = \"(0, 0) mm\", condition = \"symmetry\" }",
                   "{ name = \"axis\", path = \"(0, 0) mm\", condition = \"insulated\" }",
                   "glass.boundary: \"axis\" runs along the axis, allowed there is only the condition symmetry");
  const std::string tool_axis = "{ name = \"axis\", path = \"(0, -10) mm\", condition = \"symmetry\" }";
  expect_complaint(tool_axis, replaced("symmetry", "contact", tool_axis),
                   "tool.boundary: \"axis\" runs along the axis, allowed there is only the condition symmetry");
  EXPECT_EQ(complaint_about(replaced("symmetry", "insulated", replaced("axisymmetric", "planar"))), "");
}

TEST(SceneErrors, csv_files_without_heading_or_rows) {
  const auto text = replaced("path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"", "csv = \"points.csv\"");
  const auto file = write_scene(text) + "/points.csv";
  const auto complaint = [&](const std::string& rows) {
    std::ofstream(file) << rows;
    return complaint_about(text);
  };
  EXPECT_EQ(complaint("r_mm,z_mm\n0,0\n20,0\n20,10\n0,10\n"), "");
  EXPECT_EQ(complaint("0,0\n20,0\n"),
            file +
                ":1: glass.boundary.csv: the heading is missing (\"0,0\" was found), allowed is a "
                "heading such as r_mm,z_mm");
  for (const char* empty : {"", "\n\n", "r_mm,z_mm\n"})
    EXPECT_EQ(complaint(empty), std::to_string(line_of("(0, 0) (20, 0)")) +
                                    ": glass.boundary.csv: no points were found in \"" + file +
                                    "\", allowed is a heading such as r_mm,z_mm and rows of numbers");
}

}  // namespace
}  // namespace parison::forming
