// SPDX-License-Identifier: GPL-3.0-or-later
// Mistakes in keys, units, names, materials, interfaces, probes, output and numerics of a case.
#include <gtest/gtest.h>

#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "scene_complaint.hpp"

namespace parison::forming {
namespace {

TEST(SceneErrors, the_small_scene_itself_is_fine) {
  EXPECT_EQ(complaint_about(small_scene), "");
}

TEST(SceneErrors, unknown_key) {
  expect_complaint(
      "duration = \"2 s\"", "duraton = \"2 s\"",
      "stage.duraton: unknown key (did you mean \"duration\"?), allowed are name, duration, from, until, "
      "end_speed, gravity, tools, motion, pressure, end, air, inner_air, trapped_air, cooling, name_boundary, kind, "
      "lehr, solid");
}

TEST(SceneErrors, navier_friction_without_its_coefficient) {
  const auto message = complaint_about(replaced("friction = \"slip\"", "friction = \"navier\""));
  EXPECT_NE(message.find("tool.friction: \"navier\" lacks its coefficient, allowed is { law = \"navier\""),
            message.npos)
      << message;
}

TEST(SceneErrors, an_unknown_friction_is_told_with_every_law) {
  expect_complaint("friction = \"stick\"", "friction = \"sticky\"",
                   "tool.friction: \"sticky\" was found, allowed are \"slip\", \"stick\", \"grip\" or a table { law = "
                   "\"navier\", coefficient = \"1e6 Pa.s/m\" }");
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

TEST(SceneErrors, missing_case_file) {
  EXPECT_THROW(read_scene("no/such/case", "draft"), core::CaseError);
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

TEST(SceneErrors, probe_outside_its_body) {
  expect_complaint("point = \"(0, 5) mm\"", "point = \"(0, 11) mm\"",
                   "probe.point: \"(0, 11) mm\" lies outside \"glass\", allowed are points inside or on its outline; "
                   "with boundary = \"surface\" and a depth such as \"5 mm\" it follows the drawing");
}

TEST(SceneErrors, probe_behind_a_boundary) {
  const auto probe = [](const std::string& keys) { return keys + "point = \"(7, 4) mm\"\n"; };
  const std::string point = "point = \"(0, 5) mm\"\n";
  expect_complaint(point, probe("boundary = \"top\"\n"),
                   "probe.boundary: \"top\" was found, allowed are surface, axis");
  expect_complaint(point, probe("depth = \"2 mm\"\n"),
                   "probe.depth: a depth was found, allowed only together with \"boundary\", behind which it is");
  expect_complaint(
      point, probe("depth = \"11 mm\"\nboundary = \"surface\"\n"),
      "probe.depth: (7, 11) mm, so far behind \"surface\", lies outside \"glass\", allowed are depths that "
      "end inside");
}

TEST(SceneErrors, repeated_names) {
  expect_complaint("name = \"plunger\"", "name = \"plate\"",
                   "tool.name: \"plate\" was found twice, allowed are different names");
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
  EXPECT_EQ(numerics("initial_step = \"10 us\"\nmax_step = \"0.1 ms\""), "");
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

TEST(SceneErrors, a_swab_or_a_time_of_the_temperature_that_cannot_be) {
  const auto with = [](const std::string& line) {
    return complaint_about(replaced("friction = \"slip\"", "friction = \"slip\"\n" + line));
  };
  EXPECT_NE(with("swab = { every = 0, heat = \"100 kJ/m2\" }").find("every"), std::string::npos);
  EXPECT_NE(with("swab = { every = 5, heat = \"100 kJ\" }").find("tool.swab.heat: "), std::string::npos);
  EXPECT_NE(with("swab = { every = 5 }").find("heat"), std::string::npos);
  EXPECT_NE(with("temperature_at = \"the gob\"").find("tool.temperature_at: "), std::string::npos);
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

}  // namespace
}  // namespace parison::forming
