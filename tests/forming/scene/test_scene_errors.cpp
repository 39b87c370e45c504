// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../scene_text.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"

namespace parison::forming {
namespace {

/// Replaces a part of the small scene and expects the complaint to start at the changed line.
void expect_complaint(const std::string& from, const std::string& to, const std::string& rest) {
  EXPECT_EQ(complaint_about(replaced(from, to)), std::to_string(line_of(from)) + ": " + rest);
}

TEST(SceneErrors, the_small_scene_itself_is_fine) {
  EXPECT_EQ(complaint_about(small_scene), "");
}

TEST(SceneErrors, unknown_key) {
  expect_complaint(
      "duration = \"2 s\"", "duraton = \"2 s\"",
      "stage.duraton: unknown key (did you mean \"duration\"?), allowed are name, duration, from, until, "
      "end_speed, gravity, tools, motion, pressure, end, air, inner_air, trapped_air, cooling, name_boundary");
}

TEST(SceneErrors, navier_friction_without_its_coefficient) {
  const auto message = complaint_about(replaced("friction = \"slip\"", "friction = \"navier\""));
  EXPECT_NE(message.find("tool.friction: \"navier\" lacks its coefficient, allowed is { law = \"navier\""),
            message.npos)
      << message;
}

TEST(SceneErrors, friction_by_temperature_that_is_no_table_of_it) {
  const auto complaint = [](const std::string& coefficient) {
    return complaint_about(
        replaced("friction = \"slip\"", "friction = { law = \"navier\", coefficient = " + coefficient + " }"));
  };
  EXPECT_EQ(complaint(R"([["700 degC", "1e6 Pa.s/m"], ["1100 degC", "1e4 Pa.s/m"]])"), "");
  const auto expect = [&](const std::string& coefficient, const std::string& sentence) {
    const std::string found = complaint(coefficient);
    EXPECT_NE(found.find(sentence), std::string::npos) << found;
  };
  expect(R"([["700 degC", "1e6 Pa.s/m"], ["700 degC", "1e4 Pa.s/m"]])", "allowed are rising entries");
  expect(R"([["700 degC", "-1e6 Pa.s/m"]])", "above zero");
  expect(R"([["700 mm", "1e6 Pa.s/m"]])", "is a length");
  expect(R"(["1e6 Pa.s/m"])", "tool.friction.coefficient");
}

TEST(SceneErrors, wrong_unit) {
  expect_complaint("duration = \"2 s\"", "duration = \"2 mm\"",
                   "stage.duration: \"2 mm\" is a length, allowed is a time such as \"0.9 s\"");
}

TEST(SceneErrors, missing_csv_file) {
  const auto message = complaint_about(replaced("path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"", "csv = \"none.csv\""));
  EXPECT_EQ(message.rfind(std::to_string(line_of("(0, 0) (20, 0)")) + ": glass.boundary.csv: no file \"", 0), 0u)
      << message;
  EXPECT_NE(message.find("none.csv\", allowed is a CSV file with its path relative to the case file"),
            std::string::npos)
      << message;
}

TEST(SceneErrors, missing_case_file) {
  EXPECT_THROW(read_scene("no/such/case", "draft"), core::CaseError);
}

TEST(SceneErrors, self_crossing_profile) {
  expect_complaint("{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\"",
                   "{ name = \"surface\", path = \"(0, 0) (20, 10) (20, 0) (0, 10) mm\"",
                   "glass.boundary: the outline crosses itself (boundary \"surface\" meets boundary "
                   "\"surface\" near (0, 0) mm), "
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

TEST(SceneErrors, negative_properties) {
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

TEST(SceneErrors, glass_and_tool_that_can_touch_without_an_interface) {
  const auto text = replaced("tools = [\"plate\", \"plunger\"]\nlaw", "tools = [\"plate\"]\nlaw");
  const auto stage = text.rfind("[[stage]]");
  const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<long>(stage), '\n');
  EXPECT_EQ(complaint_about(text), std::to_string(line) +
                                       ": stage.tools: the glass and \"plunger\" can touch in stage \"press\" but have "
                                       "no interface; allowed is an [[interface]] that names the tool");
}

TEST(SceneErrors, probe_outside_its_body) {
  expect_complaint("point = \"(0, 5) mm\"", "point = \"(0, 11) mm\"",
                   "probe.point: \"(0, 11) mm\" lies outside \"glass\", allowed are points inside or on its outline");
}

TEST(SceneErrors, open_surfaces_that_radiate_need_air) {
  const auto text = replaced("[material.iron]", "emissivity = 0.9\n[material.iron]");
  EXPECT_EQ(complaint_about(text),
            std::to_string(line_of("[[stage]]", text)) +
                ": stage.air: missing, but \"glass\" exchanges heat with the air; allowed is [air] "
                "for the case or air in each stage");
}

TEST(SceneErrors, repeated_names) {
  expect_complaint("name = \"plunger\"", "name = \"plate\"",
                   "tool.name: \"plate\" was found twice, allowed are different names");
}

TEST(SceneErrors, loads_on_glass_that_does_not_flow) {
  const auto text = replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }\n", "");
  EXPECT_EQ(
      complaint_about(text).rfind(std::to_string(line_of("motion.plunger", text)) + ": stage.motion.plunger.force", 0),
      0u);
}

TEST(SceneErrors, text_that_is_no_path) {
  expect_complaint("(0, 0) (20, 0) (20, 10) (0, 10) mm", "(0, 0) (20) mm",
                   "glass.boundary.path: \"(20)\" has 1 coordinates, allowed are 2");
  const auto message = complaint_about(replaced("(0, 0) (20, 0) (20, 10) (0, 10) mm", "0, 0 to 20, 0"));
  EXPECT_NE(message.find("glass.boundary.path: \"0, 0 to 20, 0\" was found, allowed are points such as"),
            std::string::npos);
}

TEST(SceneErrors, an_output_interval_is_at_least_a_microsecond) {
  const auto interval = [](const std::string& value) {
    return complaint_about(small_scene + "[output]\ninterval = \"" + value + "\"\n");
  };
  const auto line = std::to_string(line_of("[output]", small_scene + "[output]") + 1);
  EXPECT_EQ(interval("1e-7 s"), line + ": output.interval: \"1e-7 s\" was found, allowed are intervals from 1e-6 s");
  EXPECT_NE(interval("0 s"), "");
  EXPECT_NE(interval("-1 s"), "");
  EXPECT_EQ(interval("1 us"), "");
}

TEST(SceneErrors, a_flag_is_one_that_there_is_with_a_quantity_of_its_kind) {
  const auto flags = [](const std::string& value) {
    const auto message = complaint_about(small_scene + "[output]\nflags = { " + value + " }\n");
    return message.substr(std::min(message.size(), message.find(' ') + 1));
  };
  EXPECT_EQ(flags("wall_below = \"1 mm\""), "");
  EXPECT_NE(flags("wall_bellow = \"1 mm\"").find("wall_below"), std::string::npos);
  EXPECT_NE(flags("wall_below = \"1 degC\"").find("output.flags.wall_below: \"1 degC\" is a temperature"),
            std::string::npos);
  EXPECT_NE(flags("glass_below = \"1 mm\"").find("output.flags.glass_below: \"1 mm\" is a length"), std::string::npos);
  EXPECT_NE(flags("tool_surface_above = \"0 K\""), "");
  EXPECT_NE(flags("wall_below = \"0 mm\""), "");
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

TEST(SceneErrors, numerics_that_contradict_each_other) {
  const auto numerics = [](const std::string& entry) {
    const auto message = complaint_about(small_scene + "[numerics]\n" + entry + "\n");
    return message.substr(message.find(' ') + 1);
  };
  EXPECT_EQ(
      numerics("initial_step = \"0.3 s\""),
      "numerics.initial_step: initial_step = 0.3 and max_step = 0.2 (SI) were found, allowed is initial_step up to "
      "max_step");
  EXPECT_EQ(numerics("max_step = \"0.1 ms\"").rfind("numerics.max_step: initial_step = 0.001 and", 0), 0u);
  EXPECT_EQ(numerics("min_step = \"2 ms\"").rfind("numerics.min_step: min_step = 0.002 and", 0), 0u);
  EXPECT_EQ(numerics("surface_size = \"0.3 mm\"").rfind("numerics.surface_size: skin_size = 0.0007 and", 0), 0u);
  for (const char* passes : {"21", "1000000"})
    EXPECT_EQ(numerics(std::string("passes = ") + passes),
              std::string("numerics.passes: ") + passes + " was found, allowed are up to 20");
  EXPECT_EQ(numerics("passes = 20"), "");
  EXPECT_EQ(numerics("temperature_order = 3"), "numerics.temperature_order: 3 was found, allowed are 1 and 2");
  EXPECT_EQ(numerics("initial_step = \"10 us\"\nmax_step = \"0.1 ms\""), "");
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

TEST(SceneErrors, names_that_could_be_no_file_names) {
  const auto refused = [](const std::string& from, const std::string& to) {
    const auto message = complaint_about(replaced(from, to));
    const std::string end = " was found, allowed are names of letters, digits, _ and -";
    EXPECT_GE(message.size(), end.size()) << to;
    return message.size() >= end.size() && message.substr(message.size() - end.size()) == end &&
           message.rfind(std::to_string(line_of(from)) + ": ", 0) == 0;
  };
  EXPECT_TRUE(refused("case = \"small\"", "case = \"a/b\""));
  EXPECT_TRUE(refused("[material.soft]", "[material.\"soft glass\"]"));
  EXPECT_TRUE(refused("name = \"plunger\"", "name = \"../plunger\""));
  EXPECT_TRUE(refused("name = \"press\"", "name = \"press 1\""));
  EXPECT_TRUE(refused("name = \"face\"", "name = \"face!\""));
  EXPECT_TRUE(refused("name = \"centre\"", "name = \"centre,x\""));
  expect_complaint("name = \"plunger\"", "name = \"glass\"",
                   "tool.name: \"glass\" was found, allowed is any other name for a tool");
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

TEST(SceneErrors, a_conductance_that_needs_a_pressure_on_glass_that_does_not_flow) {
  auto text = replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }\n", "");
  for (const char* law : {"pressure-viscosity", "table"}) {
    const auto changed = replaced("tools = [\"plate\", \"plunger\"]\nlaw = \"constant\"",
                                  "tools = [\"plate\", \"plunger\"]\nlaw = \"" + std::string(law) + "\"", text);
    EXPECT_EQ(complaint_about(changed), std::to_string(line_of("law = \"" + std::string(law), changed)) +
                                            ": interface.law: the glass does not flow and has no contact pressure, "
                                            "allowed are \"constant\" and \"gap\"");
  }
}

TEST(SceneErrors, a_contact_by_the_gap_with_constants_out_of_range) {
  const auto with = [](const char* touch, const char* open, const char* time, const char* closing, const char* share) {
    const auto message = complaint_about(replaced(
        "law = \"constant\"\nh = \"2000 W/m2/K\"",
        fmt::format("law = \"gap\"\ntouch_gap = \"{}\"\nopen_gap = \"{}\"\nopening_time = \"{}\"\nclosing = {}\n"
                    "accommodation = {}",
                    touch, open, time, closing, share)));
    return message.substr(std::min(message.size(), message.find(' ') + 1));
  };
  EXPECT_EQ(with("0.25 um", "40 um", "0.2 s", "1", "0.9"), "");
  EXPECT_EQ(with("50 um", "40 um", "0.2 s", "1", "0.9"),
            "interface.open_gap: an open_gap of 40 um is below the touch_gap of 50 um, allowed is one not below it");
  EXPECT_EQ(with("0.25 um", "0.1 mm", "0.2 s", "1", "0.9"),
            "interface.open_gap: an open_gap of 0.1 mm is not below the transition gap of 0.1 mm, beyond which a "
            "contact is over; "
            "allowed is less");
  EXPECT_EQ(with("0.25 um", "40 um", "0.2 s", "1", "1.1"),
            "interface.accommodation: 1.1 was found, allowed is above 0 to 1");
  EXPECT_EQ(with("0 um", "40 um", "0.2 s", "1", "0.9").rfind("interface.touch_gap: \"0 um\" was found", 0), 0u);
  EXPECT_EQ(with("0.25 um", "40 um", "0 s", "1", "0.9").rfind("interface.opening_time: \"0 s\" was found", 0), 0u);
  EXPECT_EQ(with("0.25 um", "40 um", "0.2 s", "-1", "0.9").rfind("interface.closing: ", 0), 0u);
}

TEST(SceneErrors, a_contact_by_the_gap_blames_the_key_that_is_given) {
  const auto with = [](const char* keys) {
    const auto message =
        complaint_about(replaced("law = \"constant\"\nh = \"2000 W/m2/K\"", std::string("law = \"gap\"\n") + keys));
    return message.substr(std::min(message.size(), message.find(' ') + 1));
  };
  EXPECT_EQ(with(""), "");
  const Scene alone = scene_of(replaced("law = \"constant\"\nh = \"2000 W/m2/K\"", "law = \"gap\""));
  EXPECT_NE(
      describe_scene(alone).find("0.25 um at first touch, to 40 um in about 0.25 s; closing 1, accommodation 0.9"),
      std::string::npos);
  EXPECT_EQ(with("touch_gap = \"50 um\""),
            "interface.touch_gap: an open_gap of 40 um is below the touch_gap of 50 um, allowed is one not below it");
  EXPECT_EQ(
      with("transition_gap = \"30 um\""),
      "interface.transition_gap: an open_gap of 0.04 mm is not below the transition gap of 0.03 mm, beyond which a "
      "contact is over; allowed is less");
}

TEST(SceneErrors, a_swabbing_factor_that_is_not_above_zero) {
  const auto message = complaint_about(replaced("friction = \"slip\"", "friction = \"slip\"\nswabbing = 0"));
  EXPECT_NE(message.find("tool.swabbing: 0 was found, allowed is"), std::string::npos) << message;
}

TEST(SceneErrors, a_tool_that_carries_no_heat_with_glass_that_does) {
  const std::string dense = "[material.dense]\ndensity = \"7800 kg/m3\"\n[glass]\n";
  const std::string text = replaced("[glass]\n", dense);
  const auto message = complaint_about(
      replaced("name = \"plunger\"\nmaterial = \"iron\"", "name = \"plunger\"\nmaterial = \"dense\"", text));
  EXPECT_NE(message.find("tool.material: \"dense\" has no conductivity and heat_capacity"), message.npos) << message;
}

TEST(SceneErrors, a_tool_with_the_thin_wall_limit_of_the_glass) {
  const std::string clear = R"([material.clear]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
radiation = { refractive_index = 1.5, absorption = "50 1/m", thin_wall = true }
[glass]
)";
  const std::string text = replaced("[glass]\n", clear);
  const std::string used =
      replaced("name = \"plunger\"\nmaterial = \"iron\"", "name = \"plunger\"\nmaterial = \"clear\"", text);
  const auto message = complaint_about(used);
  EXPECT_NE(message.find("tool.material: \"clear\" has radiation with thin_wall = true, which only the glass can have"),
            message.npos)
      << message;
  EXPECT_EQ(complaint_about(replaced("thin_wall = true", "thin_wall = false", used)), "");
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
