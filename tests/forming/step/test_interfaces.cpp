// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "figure.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"

namespace parison::forming {
namespace {

/// The small scene with another law between glass and tools.
std::string with_law(const std::string& law) {
  return replaced("law = \"constant\"\nh = \"2000 W/m2/K\"\n", law);
}

std::string complaint_about_law(const std::string& law) {
  const auto message = complaint_about(with_law(law));
  return message.substr(message.find(' ') + 1);
}

TEST(Interfaces, a_conductance_that_is_negative_or_not_finite_is_refused) {
  const std::string allowed = "allowed is a heat transfer coefficient such as \"5000 W/m2/K\"";
  const auto of = [](const char* h) {
    return complaint_about_law(std::string("law = \"constant\"\nh = \"") + h + " W/m2/K\"\n");
  };
  EXPECT_EQ(of("-5"), "interface.h: \"-5 W/m2/K\" was found, " + allowed + ", above zero");
  EXPECT_EQ(of("0"), "interface.h: \"0 W/m2/K\" was found, " + allowed + ", above zero");
  for (const char* bad : {"nan", "inf", "-inf"})
    EXPECT_EQ(of(bad), "interface.h: \"" + std::string(bad) + " W/m2/K\" does not start with a number, " + allowed);
  EXPECT_EQ(complaint_about_law("law = \"constant\"\nh = \"1e308 kW/m2/K\"\n"),
            "interface.h: \"1e308 kW/m2/K\" is too large, " + allowed + " of up to 1e+18 kg s^-3 K^-1");
  EXPECT_EQ(of("1e999"),
            "interface.h: \"1e999 W/m2/K\" starts with a number that is too large or too near to zero, " + allowed);
  const std::string rest = "p_ref = \"0.2 MPa\"\neta_ref = \"1e3 Pa.s\"\na = 1\nb = 0.25\n";
  const std::string law = "law = \"pressure-viscosity\"\n";
  EXPECT_EQ(complaint_about_law(law + "h0 = \"-500 W/m2/K\"\nh1 = \"2e4 W/m2/K\"\n" + rest),
            "interface.h0: \"-500 W/m2/K\" was found, " + allowed + ", above zero");
  EXPECT_EQ(complaint_about_law(law + "h0 = \"500 W/m2/K\"\nh1 = \"nan W/m2/K\"\n" + rest),
            "interface.h1: \"nan W/m2/K\" does not start with a number, " + allowed);
  EXPECT_EQ(complaint_about_law(law + "h0 = \"500 W/m2/K\"\nh1 = \"2e4 W/m2/K\"\n" + replaced("a = 1", "a = nan", rest))
                .rfind("interface.a: ", 0),
            0u);
}

TEST(Interfaces, a_table_of_wrong_order_or_size_is_refused) {
  const auto table = [](const std::string& pressure, const std::string& viscosity, const std::string& h) {
    return complaint_about_law("law = \"table\"\npressure = " + pressure + "\nviscosity = " + viscosity + "\nh = " + h +
                               "\n");
  };
  const std::string p = "[\"1 kPa\", \"1 MPa\"]", eta = "[\"1e3 Pa.s\", \"1e6 Pa.s\"]",
                    row = "[\"500 W/m2/K\", \"400 W/m2/K\"]";
  EXPECT_EQ(table(p, eta, "[" + row + ", " + row + "]"), "");
  EXPECT_EQ(table("[\"1 MPa\", \"1 kPa\"]", eta, "[" + row + ", " + row + "]"),
            "interface.pressure: \"1 kPa\" is not greater than the entry before, allowed are increasing entries");
  EXPECT_EQ(table(p, "[\"1e6 Pa.s\", \"1e6 Pa.s\"]", "[" + row + ", " + row + "]"),
            "interface.viscosity: \"1e6 Pa.s\" is not greater than the entry before, allowed are increasing entries");
  EXPECT_EQ(table("[\"0 Pa\", \"1 kPa\"]", eta, "[" + row + ", " + row + "]")
                .rfind("interface.pressure: \"0 Pa\" was found", 0),
            0u);
  EXPECT_EQ(table(p, eta, "[" + row + "]"),
            "interface.h: 1 members were found, allowed is one for each of the 2 pressures");
  EXPECT_EQ(table(p, eta, "[" + row + ", [\"500 W/m2/K\"]]"),
            "interface.h: 1 members were found, allowed is one for each of the 2 viscosities");
  EXPECT_EQ(
      table(p, eta, "[" + row + ", [\"500 W/m2/K\", \"-4 W/m2/K\"]]").rfind("interface.h: \"-4 W/m2/K\" was found", 0),
      0u);
  EXPECT_EQ(table("[]", eta, "[]"), "interface.pressure: an empty list was found, allowed is at least one entry");
}

TEST(Interfaces, a_named_boundary_is_open_to_contact_and_needs_an_interface_too) {
  const std::string contact = "(20, 10) (0, 10) mm\", condition = \"contact\"";
  const std::string whole = "name = \"surface\", path = \"(0, 0) (20, 0) " + contact;
  auto closed = replaced(whole,
                         "name = \"bottom\", path = \"(0, 0) (20, 0) mm\", condition = \"fixed\" },\n"
                         "  { name = \"surface\", path = \"" +
                             replaced("contact", "air", contact));
  closed = replaced("tools = [\"plate\", \"plunger\"]\nlaw", "tools = [\"plate\"]\nlaw", closed);
  closed = replaced("geometry",
                    "air = { temperature = \"50 degC\", h = \"9 W/m2/K\", ambient = \"50 degC\" }\ngeometry", closed);
  EXPECT_EQ(complaint_about(closed), "");
  const auto open =
      replaced("gravity = ",
               "name_boundary = [{ name = \"top\", from = \"(20, 10) mm\", to = \"(0, 10) mm\" }]\ngravity = ", closed);
  EXPECT_NE(complaint_about(open).find(
                "stage.tools: the glass and \"plunger\" can touch in stage \"press\" but have no interface"),
            std::string::npos)
      << complaint_about(open);
}

/// Heat alone: the disc on its plate, the plunger's face at a height above it, mm.
std::string static_scene(const std::string& height) {
  auto text = replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }\n", "");
  text = text.substr(0, text.find("[[stage]]\nname = \"press\"")) + text.substr(text.find("[[probe]]"));
  text = replaced("tools = [\"plate\"]\n[[probe]]", "tools = [\"plate\", \"plunger\"]\n[[probe]]", text);
  return replaced("duration = \"1 s\"", "duration = \"0.05 s\"",
                  replaced("10 mm\"\nboundary", height + " mm\"\nboundary", text));
}

TEST(Interfaces, one_on_bodies_that_never_meet_is_warned_of) {
  const auto apart = run_in_folder(scene_of(static_scene("30")), tests::absent_folder());
  EXPECT_TRUE(apart.facts.completed) << apart.facts.reason;
  ASSERT_EQ(apart.facts.warnings.size(), 1u);
  EXPECT_EQ(
      apart.facts.warnings[0],
      "the glass never reached plunger: during the whole run they stayed farther apart than 0.1 mm, and no heat passed "
      "between them. Where it should reach it, the glass was too cold or too little, or was not pressed or blown far "
      "enough, or the tool is not where it should be (`parison check --picture` draws it)");
  const auto together = run_in_folder(scene_of(static_scene("10")), tests::absent_folder());
  EXPECT_TRUE(together.facts.warnings.empty());
}

/// A ball in a closed shell that it does not touch: all that it loses is what the shell takes.
const char* const ball_in_shell = R"(case = "shells"
geometry = "axisymmetric"
enclosure = true
air = { temperature = "20 degC", h = "0 W/m2/K", ambient = "20 degC" }
stage = [{ name = "s", duration = "5 s", tools = ["shell"] }]
interface = [{ tools = ["shell"], law = "constant", h = "1 W/m2/K" }]
[material.m]
density = "2500 kg/m3"
heat_capacity = "1000 J/kg/K"
conductivity = "500 W/m/K"
emissivity = 0.8
radiation = { model = "none" }
[glass]
material = "m"
temperature = "1000 degC"
boundary = [{ name = "surface", path = "arc centre (0, 0) mm radius 10 mm from -90 deg to 90 deg", condition = "air" },
 { name = "axis", path = "(0, -10) mm", condition = "symmetry" }]
[[tool]]
name = "shell"
material = "m"
temperature = "300 degC"
boundary = [{ name = "inner", path = "arc centre (0, 0) mm radius 20 mm from 90 deg to -90 deg", condition = "contact" },
 { name = "axis1", path = "(0, -24) mm", condition = "symmetry" },
 { name = "outer", path = "arc centre (0, 0) mm radius 24 mm from -90 deg to 90 deg", condition = "insulated" },
 { name = "axis2", path = "(0, 20) mm", condition = "symmetry" }]
)";

TEST(Interfaces, light_between_bodies_that_never_meet_is_told_as_the_heat_that_the_glass_lost) {
  const auto outcome = run_in_folder(scene_of(ball_in_shell), tests::absent_folder());
  ASSERT_EQ(outcome.facts.warnings.size(), 1u);
  const std::string &told = outcome.facts.warnings[0], before = "no heat passed between them by contact; ";
  const auto at = told.find(before);
  ASSERT_NE(at, std::string::npos) << told;
  EXPECT_NEAR(std::stod(told.substr(at + before.size())) / outcome.state.totals.to_air, 1, 2e-3) << told;
  EXPECT_NE(told.find(" J came to shell through its open faces by light and air. Where"), std::string::npos) << told;
}

TEST(Interfaces, contact_without_resistance_neither_shortens_the_steps_nor_changes_the_heat) {
  // Two half-spaces brought together: heat = area 2 dT/(1/e1 + 1/e2) sqrt(t/pi), e the effusivities.
  const double e1 = std::sqrt(1.3 * 2400 * 1300), e2 = std::sqrt(46.0 * 7200 * 490), time = 0.2;
  const double exact = M_PI * 0.02 * 0.02 * 2 * 600 / (1 / e1 + 1 / e2) * std::sqrt(time / M_PI);
  auto text =
      replaced("duration = \"1 s\"", "duration = \"0.2 s\"", with_law("law = \"constant\"\nh = \"1e9 W/m2/K\"\n"));
  text = text.substr(0, text.find("[[stage]]\nname = \"press\"")) + text.substr(text.find("[[probe]]"));
  const auto outcome = run_in_folder(scene_of(text), tests::absent_folder());
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_LT(outcome.state.totals.steps + outcome.facts.diagnostics.steps.rejected, 40);
  tests::expect_at_most("contact at h = 1e9 W/m2/K against two half-spaces: heat in 0.2 s off by",
                        std::abs(outcome.state.tools[0].heat_received / exact - 1), 0.05);
}

TEST(Interfaces, overrides_change_the_scene_the_fingerprint_and_are_told) {
  const auto folder = write_scene(small_scene);
  const std::vector<std::string> overrides{"interface.plate.h=\"1e9 W/m2/K\"", "tool.plunger.temperature=480 degC"};
  const Scene plain = read_scene(folder, "draft"), changed = read_scene(folder, "draft", overrides);
  ASSERT_EQ(changed.interfaces.size(), 2u);
  for (const Interface& interface : changed.interfaces)
    EXPECT_EQ(std::get<contact::ConstantConductance>(interface.law).h, interface.tool == 0 ? 1e9 : 2000);
  EXPECT_DOUBLE_EQ(changed.tools[1].initial_temperature, 753.15);
  EXPECT_DOUBLE_EQ(plain.tools[1].initial_temperature, 673.15);
  EXPECT_NE(changed.fingerprint, plain.fingerprint);
  EXPECT_NE(changed.fingerprint, read_scene(folder, "draft", {overrides[0]}).fingerprint);
  EXPECT_EQ(plain.fingerprint, read_scene(folder, "draft", {}).fingerprint);
  EXPECT_NE(describe_scene(changed).find("override            tool.plunger.temperature=480 degC\n"), std::string::npos);
  EXPECT_THROW(read_scene(folder, "draft", {"tool.plunger.temprature=480 degC"}), core::CaseError);
}

}  // namespace
}  // namespace parison::forming
