// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of the heat: the skin at a contact, tables over temperature, the coupling with the flow.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "../../scene_text.hpp"
#include "core/io/files.hpp"
#include "forming/diagnostics/temperature_bounds.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/run/run.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {
namespace {

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
  write_summary(folder, scene, outcome);
  const std::string mark = core::read_text(folder + "/NOT_TRUSTWORTHY.txt");
  EXPECT_NE(mark.find("thermal_skin is "), std::string::npos) << mark;
  const std::string summary = core::read_text(folder + "/summary.json");
  EXPECT_NE(summary.find("\"trustworthy\": false"), std::string::npos);
  EXPECT_NE(summary.find("\"name\": \"thermal_skin\""), std::string::npos);
}

TEST(Checks, glass_above_all_that_heats_it_is_told_with_stage_place_and_size_until_the_cells_are_as_thin_as_the_skin) {
  // The disc on its plate for a moment, with a contact that chills it at once.
  const auto chilled = [](const std::string& skin) {
    std::string text = replaced("h = \"2000 W/m2/K\"", "h = \"50000 W/m2/K\"");
    text = text.substr(0, text.find("[[stage]]\nname = \"press\"")) + "[numerics]\nskin_size = \"" + skin + "\"\n";
    return scene_of(replaced("duration = \"1 s\"", "duration = \"20 ms\"", text));
  };
  const Scene thick = chilled("1.5 mm"), thin = chilled("0.03 mm");
  const RunOutcome coarse = run(thick, {}, {}), fine = run(thin, {}, {});
  ASSERT_TRUE(coarse.facts.completed && fine.facts.completed) << coarse.facts.reason << fine.facts.reason;
  const HotGlass& hottest = coarse.facts.diagnostics.hot_glass;
  const std::string told = hot_glass_text(thick, hottest);
  std::printf("%s\nin thin cells %.2f K\n", told.c_str(), fine.facts.diagnostics.hot_glass.above);
  EXPECT_GT(hottest.above, 20);
  EXPECT_EQ(told.find(fmt::format("{:.0f} K above all that heats it, in rest at ", hottest.above)), 0u) << told;
  EXPECT_GT(hottest.z, 0.05e-3);
  EXPECT_LT(hottest.z, 2.5e-3) << "one cell behind the skin";
  EXPECT_GT(hottest.volume_share, 0);
  EXPECT_LT(hottest.volume_share, 0.4);
  EXPECT_LT(fine.facts.diagnostics.hot_glass.above, 0.5 * hottest.above);
}

TEST(Checks, work_that_glass_too_hot_fails_to_do_is_that_of_its_viscosity) {
  const Scene scene =
      scene_of(replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }",
                        "viscosity = { law = \"vft\", A = -2.309, B = \"3922 K\", T0 = \"291 degC\" }"));
  const State start = initial_state(scene);
  const auto cells = start.glass.mesh.cells().size();
  const std::vector<double> dissipation(cells, 2.0 / static_cast<double>(cells));
  const double source = hottest_source(scene, 0);
  const auto missing = [&](double above) {
    return hot_work(scene, start, Eigen::VectorXd::Constant(start.glass.mesh.node_count(), source + above), dissipation,
                    source, 0.5);
  };
  const auto viscosity = [](double kelvin) { return std::pow(10, 3922 / (kelvin - 291 - 273.15)); };
  EXPECT_EQ(missing(-1), 0);
  EXPECT_NEAR(missing(40), viscosity(source) / viscosity(source + 40) - 1, 1e-9);
}

/// The check of tables over temperature, of the small scene with some values of it replaced; absent without a table.
std::optional<Check> table_check(const std::string& from, const std::string& to) {
  const auto outcome = run(scene_of(replaced(from, to)), {}, {});
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  for (const Check& check : outcome.facts.checks)
    if (check.name == "property_tables") return check;
  return {};
}

TEST(Checks, temperatures_beyond_the_table_of_a_property_are_told) {
  EXPECT_FALSE(table_check("", ""));
  const std::string constant = "conductivity = \"1.3 W/m/K\"";
  const auto conductivity = [&](const std::string& hottest) {
    return table_check(constant, "conductivity = [[\"20 degC\", \"1 W/m/K\"], [\"" + hottest + "\", \"1.3 W/m/K\"]]");
  };
  EXPECT_EQ(conductivity("1100 degC")->value, 0);
  EXPECT_LT(conductivity("1001 degC")->value, 1e-3);  // glass behind the skin is a little too hot for a moment
  const Check beyond = *conductivity("800 degC");
  EXPECT_NEAR(beyond.value, 0.3 / 780 * 200 / 1.3, 2e-3);  // the glass begins at 1000 degC and cools
  EXPECT_EQ(beyond.verdict(), Verdict::beyond);
  EXPECT_NE(beyond.sentence.find("the conductivity of the glass may be wrong"), std::string::npos);
  EXPECT_NE(beyond.sentence.find("beyond the table for 3 s, by up to 20"), std::string::npos) << beyond.sentence;
}

TEST(Checks, glass_far_hotter_than_the_measured_viscosities_is_told) {
  // Points of a law of Vogel, Fulcher and Tammann up to a temperature, used by glass of 1000 degC.
  const auto law = [](double celsius) { return std::pow(10, -2.309 + 3922 / (celsius - 291)); };
  const auto told = [&](double hottest) {
    std::string points;
    for (double T = 500; T < hottest + 1; T += 50) points += fmt::format("[\"{} degC\", \"{} Pa.s\"], ", T, law(T));
    return *table_check("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }",
                        "viscosity = { law = \"table\", points = [" + points + "] }");
  };
  EXPECT_EQ(told(1000).verdict(), Verdict::inside);
  const Check far = told(950);
  EXPECT_EQ(far.verdict(), Verdict::beyond);
  const double slope = std::log(10) * 3922 / std::pow(950 - 291, 2),
               exact = std::log(law(1000) / law(950)) + 50 * slope;
  EXPECT_GT(far.value, 0.5 * exact);
  EXPECT_LT(far.value, 2 * exact);
}

/// A disc of container glass that conducts well, pressed between plates that keep it as cold as its own work lets them.
std::string pressed_and_cooled(const std::string& numerics) {
  const std::string plates = R"(material = "heavy"
temperature = "527 degC"
friction = "slip"
)";
  return R"(case = "cooled"
geometry = "axisymmetric"
interface = [{ tools = ["base", "ram"], law = "constant", h = "1e5 W/m2/K" }]
[material.heavy]
density = "7200 kg/m3"
heat_capacity = "1e9 J/kg/K"
conductivity = "1e6 W/m/K"
)" + container_glass("1e8 W/m/K") +
         R"([glass]
material = "glass"
temperature = "1027 degC"
boundary = [{ name = "surface", path = "(0, 0) (20, 0) (20, 10) (0, 10) mm", condition = "contact" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
[[tool]]
name = "base"
)" + plates +
         R"(boundary = [{ name = "face", path = "(60, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -20) mm", condition = "symmetry" },
  { name = "rest", path = "(60, -20) (60, 0) mm", condition = "insulated" }]
[[tool]]
name = "ram"
position = "10 mm"
)" + plates +
         R"(boundary = [{ name = "face", path = "(0, 0) (60, 0) mm", condition = "contact" },
  { name = "rest", path = "(60, 20) (0, 20) mm", condition = "insulated" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
[[stage]]
name = "press"
duration = "0.5 s"
tools = ["base", "ram"]
motion.ram = { offset = [["0 s", "10 mm"], ["0.5 s", "5 mm"]] }
[numerics]
)" + numerics;
}

TEST(Checks, glass_that_its_own_work_keeps_warm_is_told_where_the_steps_do_not_follow) {
  const auto coupling = [](const std::string& numerics) {
    const auto outcome = run(scene_of(pressed_and_cooled(numerics)), {}, {});
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    const auto& all = outcome.facts.checks;
    const auto check = std::find_if(all.begin(), all.end(), [](const Check& one) { return one.name == "coupling"; });
    std::printf("%s: coupling %.4f, work %.0f J\n", numerics.c_str(), check->value, outcome.state.totals.work.tools);
    return std::pair{*check, outcome.state.totals.work.tools};
  };
  const auto [fine, work] = coupling("max_step = \"2 ms\"");
  const auto [coarse, wrong_work] = coupling("max_step = \"50 ms\"\nwork_per_step = 1e6");
  EXPECT_EQ(fine.verdict(), Verdict::inside);
  EXPECT_GT(std::abs(wrong_work / work - 1), 0.02);
  EXPECT_NE(coarse.verdict(), Verdict::inside);
}

}  // namespace
}  // namespace parison::forming
