// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/run/folder_run.hpp"

namespace parison::forming {
namespace {

Check some_check(double value) {
  return {"drift", value, 0.01, 0.1, "%", "the glass lost so much; do something"};
}

TEST(Checks, a_number_is_inside_beyond_or_far_beyond_and_no_number_is_the_worst) {
  EXPECT_EQ(some_check(0.01).verdict(), Verdict::inside);
  EXPECT_EQ(some_check(0.02).verdict(), Verdict::beyond);
  EXPECT_EQ(some_check(0.2).verdict(), Verdict::not_trustworthy);
  EXPECT_EQ(some_check(std::numeric_limits<double>::quiet_NaN()).verdict(), Verdict::not_trustworthy);
  EXPECT_FALSE(trustworthy({some_check(0), some_check(0.2)}));
  EXPECT_TRUE(trustworthy({some_check(0), some_check(0.02)}));
}

TEST(Checks, the_verdict_counts_or_names_them_and_a_complaint_has_number_limit_and_advice) {
  EXPECT_EQ(verdict_sentence({some_check(0), some_check(0)}), "all 2 checks inside their limits");
  EXPECT_EQ(verdict_sentence({some_check(0), some_check(0.02)}), "drift beyond the limit; of 2 checks");
  EXPECT_EQ(verdict_sentence({some_check(0.2)}), "not trustworthy: drift far beyond the limit; of 1 checks");
  EXPECT_TRUE(complaints({some_check(0)}).empty());
  ASSERT_EQ(complaints({some_check(0.02)}).size(), 1u);
  EXPECT_EQ(complaints({some_check(0.02)})[0], "drift is 2 %, the limit is 1 %: the glass lost so much; do something");
}

/// The disc on its plate, heat alone, on cells that are far too coarse for the time.
std::string coarse_contact(const std::string& h, const std::string& duration) {
  auto text = replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }\n", "");
  text = text.substr(0, text.find("[[stage]]\nname = \"press\"")) + text.substr(text.find("[[probe]]"));
  text = replaced("duration = \"1 s\"", "duration = \"" + duration + "\"", text);
  text = replaced("h = \"2000 W/m2/K\"", "h = \"" + h + "\"", text);
  return replaced("[glass]\n", "[glass]\nmesh = { size = \"5 mm\", contact_size = \"5 mm\" }\n", text);
}

TEST(Checks, heat_through_cells_that_do_not_resolve_the_skin_is_told_with_the_size_of_its_error) {
  const std::string folder = tests::absent_folder();
  const Scene scene = scene_of(coarse_contact("1e5 W/m2/K", "0.05 s"));
  const auto outcome = run_in_folder(scene, folder);
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  const auto& all = outcome.facts.checks;
  const auto skin =
      std::find_if(all.begin(), all.end(), [](const Check& check) { return check.name == "thermal_skin"; });
  ASSERT_NE(skin, all.end());
  // Two half-spaces brought together.
  const double e1 = std::sqrt(1.3 * 2400 * 1300), e2 = std::sqrt(46.0 * 7200 * 490), h = 1e5, time = 0.05;
  const double b = h * (1 / e1 + 1 / e2), y = b * std::sqrt(time);
  const double exact =
      M_PI * 0.02 * 0.02 * h * 600 * ((1 / (y * std::sqrt(M_PI)) - 1) / (b * b) + 2 * std::sqrt(time / M_PI) / b);
  const double error = outcome.state.tools[0].heat_received / exact - 1;
  std::printf("estimated %.3f, found %.3f\n", skin->value, error);
  EXPECT_GT(error, 0.1);
  EXPECT_NEAR(skin->value, error, 0.3 * error);
  EXPECT_EQ(skin->verdict(), Verdict::not_trustworthy);
  EXPECT_NE(skin->sentence.find("at the contact with plate"), std::string::npos);
  EXPECT_FALSE(trustworthy(all));
  write_summary(folder, scene, outcome.state, outcome.facts);
  const std::string mark = core::read_text(folder + "/NOT_TRUSTWORTHY.txt");
  EXPECT_NE(mark.find("thermal_skin is "), std::string::npos) << mark;
  const std::string summary = core::read_text(folder + "/summary.json");
  EXPECT_NE(summary.find("\"trustworthy\": false"), std::string::npos);
  EXPECT_NE(summary.find("\"name\": \"thermal_skin\""), std::string::npos);
}

TEST(Checks, glass_that_a_cup_holds_at_rest_raises_none) {
  const std::string text = R"(case = "rest"
geometry = "axisymmetric"
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "100 Pa.s" }
[glass]
material = "liquid"
boundary = [{ name = "bottom", path = "(0, 0) (20, 0) mm", condition = "contact" },
  { name = "side", path = "(20, 20) mm", condition = "contact" },
  { name = "top", path = "(0, 20) mm", condition = "air" }, { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
[[tool]]
name = "cup"
friction = "slip"
boundary = [{ name = "outside", path = "(0, -10) (30, -10) (30, 40) (20, 40) mm", condition = "insulated" },
  { name = "inside", path = "(20, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -10) mm", condition = "symmetry" }]
[[stage]]
name = "rest"
duration = "1 s"
tools = ["cup"]
)";
  for (const char* load : {"gravity = \"-9.81 m/s2\"\n", "pressure.top = \"1 bar\"\n", "pressure.top = \"1 Pa\"\n"}) {
    const auto outcome = run_in_folder(scene_of(text + load), tests::absent_folder());
    EXPECT_TRUE(outcome.facts.completed) << load << outcome.facts.reason;
    EXPECT_EQ(complaints(outcome.facts.checks), std::vector<std::string>{}) << load;
    EXPECT_GT(outcome.facts.checks.size(), 8u);
  }
}

/// The disc pressed at 10 mm/s to half its height between plates without friction or heat.
const std::string slipping_press = [] {
  std::string text = replaced("heat_capacity = \"1300 J/kg/K\"\nconductivity = \"1.3 W/m/K\"\n", "");
  text = text.substr(0, text.find("[material.iron]")) + text.substr(text.find("[glass]"));
  text = text.substr(0, text.find("[[interface]]")) + R"([[stage]]
name = "press"
duration = "0.5 s"
tools = ["plate", "plunger"]
motion.plunger = { offset = [["0 s", "10 mm"], ["0.5 s", "5 mm"]] }
)";
  for (const char* gone : {"material = \"iron\"\ntemperature = \"400 degC\"\n",
                           "material = \"iron\"\ntemperature = \"400 degC\"\n", "temperature = \"1000 degC\"\n"})
    text = replaced(gone, "", text);
  text = replaced("friction = \"stick\"", "friction = \"slip\"", text);
  return replaced(
      "(0, 0) (15, 0) mm", "(0, 0) (60, 0) mm",
      replaced("(15, 20) (0, 20) mm", "(60, 20) (0, 20) mm",
               replaced("(30, 0) (0, 0) mm", "(60, 0) (0, 0) mm", replaced("(30, -10) mm", "(60, -10) mm", text))));
}();

TEST(Checks, glass_stiffer_than_the_cap_of_the_viscosity_that_is_made_to_flow_is_told) {
  const auto beyond = [](const std::string& temperature) {
    const std::string text =
        replaced("{ law = \"constant\", value = \"1e4 Pa.s\" }",
                 "{ law = \"vft\", A = -2.309, B = \"3922 K\", T0 = \"291 degC\" }",
                 replaced("material = \"soft\"\n", "material = \"soft\"\ntemperature = \"" + temperature + "\"\n",
                          slipping_press));
    const auto outcome = run_in_folder(scene_of(text), tests::absent_folder());
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    return complaints(outcome.facts.checks);
  };
  EXPECT_TRUE(beyond("700 degC").empty());
  const auto stiff = beyond("500 degC");
  ASSERT_EQ(stiff.size(), 1u);
  EXPECT_EQ(stiff[0].rfind("viscosity_cap is 1e+02 %", 0), 0u) << stiff[0];
}

TEST(History, the_force_is_that_of_the_height_beside_it) {
  const std::string folder = tests::absent_folder();
  const auto outcome = run_in_folder(scene_of(slipping_press), folder);
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  std::istringstream rows(core::read_text(folder + "/history.csv"));
  std::string line, field;
  std::getline(rows, line);
  std::vector<std::string> names;
  for (std::istringstream in(line); std::getline(in, field, ',');) names.push_back(field);
  const auto column = [&](const char* name) { return std::find(names.begin(), names.end(), name) - names.begin(); };
  double worst = 0;
  int count = 0;
  while (std::getline(rows, line)) {
    std::vector<std::string> fields;
    for (std::istringstream in(line); std::getline(in, field, ',');) fields.push_back(field);
    const double height = 1e-3 * std::stod(fields[column("plunger_position_mm")]);
    const double exact = -3 * 1e4 * M_PI * 0.02 * 0.02 * 0.01 * 0.01 / (height * height);
    worst = std::max(worst, std::abs(std::stod(fields[column("plunger_force_N")]) / exact - 1));
    ++count;
  }
  std::printf("%d rows, force off by %.4f at most\n", count, worst);
  EXPECT_GT(count, 5);
  EXPECT_LT(worst, 0.015);  // the force in the middle of a step is 6 % off and more
}

}  // namespace
}  // namespace parison::forming
