// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>

#include "../scene_text.hpp"
#include "core/io/files.hpp"
#include "core/io/json.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/run/run.hpp"

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

TEST(Checks, the_verdict_of_a_run_that_stopped_early_says_so) {
  Summary summary{};
  summary.run.checks = {some_check(0)};
  summary.run.completed = true;
  EXPECT_EQ(verdict_line(summary), "  verdict               all 1 checks inside their limits\n");
  summary.run.completed = false;
  EXPECT_EQ(verdict_line(summary),
            "  verdict               stopped before its end; until then all 1 checks inside their limits\n");
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

/// A number that a check watches in the results of a run, and a way to spoil it.
struct Spoilt {
  const char* check;
  std::function<void(State&, RunFacts&, double)> spoil;  ///< by a factor of some size
};

const std::vector<Spoilt> spoilt_numbers = {
    {"energy_imbalance", [](State& state, RunFacts&, double x) { state.totals.to_air += x * state.totals.to_tools; }},
    {"interface_flux", [](State& state, RunFacts&, double x) { state.totals.max_flux_mismatch = x; }},
    {"thermal_skin",
     [](State& state, RunFacts&, double x) { state.tools[0].skin.wrong = x * state.tools[0].skin.exchanged; }},
    {"overshoot", [](State& state, RunFacts&, double x) { state.glass.bounds.overshoot = x * 1e3; }},
    {"overshoot", [](State& state, RunFacts&, double x) { state.tools[1].bounds.overshoot = x * 1e3; }},
    {"undershoot", [](State& state, RunFacts&, double x) { state.glass.bounds.undershoot = x * 1e3; }},
    {"undershoot", [](State& state, RunFacts&, double x) { state.tools[0].bounds.undershoot = x * 1e3; }},
    {"conductance_table", [](State& state, RunFacts&, double) { state.totals.clamped_lookups = 1; }},
    {"work_balance", [](State&, RunFacts& facts,
                        double x) { facts.stages.back().work.tools += x * facts.stages.back().work.dissipation; }},
    {"volume_drift", [](State& state, RunFacts&, double x) { state.totals.max_drift = x; }},
    {"penetration", [](State& state, RunFacts&, double x) { state.totals.penetration_share = x; }},
    {"edge_penetration", [](State& state, RunFacts&, double x) { state.totals.edge_penetration_share = x; }},
    {"axis", [](State& state, RunFacts&, double x) { state.totals.off_axis = x * 0.01; }},
    {"flow_resolution",
     [](State& state, RunFacts&, double x) { state.totals.unresolved_work = x * state.totals.sampled_work; }},
    {"failed_meshes", [](State& state, RunFacts&, double) { state.totals.remeshing.failed = 2; }},
    {"mesh_coarsening", [](State& state, RunFacts&, double x) { state.totals.remeshing.coarsening_factor = 1 + x; }},
    {"locked_contacts", [](State&, RunFacts& facts,
                           double) { facts.solver_statistics.locked_contacts = facts.solver_statistics.contacts; }},
    {"step_collapse", [](State& state, RunFacts&, double) { state.totals.short_steps = state.totals.steps; }},
    {"inertia", [](State& state, RunFacts&, double x) { state.totals.max_reynolds = 10 * x; }},
    {"coupling",
     [](State& state, RunFacts&, double x) { state.totals.unforeseen_work = x * state.totals.work.dissipation; }},
    {"viscosity_cap",
     [](State& state, RunFacts&, double x) { state.totals.capped_work = x * state.totals.work.dissipation; }},
};

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

TEST(Checks, a_mapped_mesh_of_a_single_division_is_told) {
  const auto told = [](const std::string& divisions) {
    const std::string text = R"(case = "block"
geometry = "planar"
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e4 Pa.s" }
[glass]
material = "liquid"
mesh = { mapped = )" + divisions +
                             R"( }
boundary = [ { name = "bottom", path = "(0, 0) (10, 0) mm", condition = "symmetry" }, { name = "side", path = "(10, 10) mm", condition = "air" },
  { name = "top", path = "(0, 10) mm", condition = "air" }, { name = "middle", path = "(0, 0) mm", condition = "symmetry" } ]
[[stage]]
name = "press"
duration = "0.01 s"
pressure.top = "0.1 bar"
)";
    const Scene scene = scene_of(text);
    const RunOutcome outcome = run(scene);
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    const Checks found = checks(scene, outcome.state, outcome.facts);
    const auto at =
        std::find_if(found.begin(), found.end(), [](const Check& c) { return c.name == "single_division"; });
    return at != found.end() && at->value > at->limit;
  };
  EXPECT_TRUE(told("[1, 5]"));
  EXPECT_TRUE(told("[5, 1]"));
  EXPECT_FALSE(told("[2, 5]"));
}

TEST(Checks, a_thick_shell_of_two_divisions_is_told_and_one_of_four_is_right) {
  // Blown up until its inner radius has grown from a to 2.25 a, by a' = p a/(4 eta (1 - a^3/b^3)).
  const double a = 5e-3, b = 20e-3, growth = 2.25, eta = 1e8, pressure = 1e6, shell = b * b * b - a * a * a;
  const auto remaining = [&](double r) { return 1 - r * r * r / (shell + r * r * r); };
  double time = 0;
  constexpr int parts = 1000;
  for (int i = 0; i < parts; ++i) {
    const double step = (growth - 1) * a / parts, r = a + (i + 0.5) * step;
    time += 4 * eta * remaining(r) / (pressure * r) * step;
  }
  const double wall = std::cbrt(shell + std::pow(growth * a, 3)) - growth * a;
  const auto blown = [&](int divisions) {
    const std::string text = fmt::format(R"(case = "shell"
geometry = "axisymmetric"
stage = [{{ name = "blow", duration = "{} s", pressure.inner = "{} Pa" }}]
numerics = {{ surface_size = "2.5 mm", skin_size = "2.5 mm", strain_per_step = 0.04, max_step = "{} s" }}
[material.liquid]
density = "2400 kg/m3"
viscosity = {{ law = "constant", value = "{} Pa.s" }}
[glass]
material = "liquid"
mesh = {{ mapped = [{}, 24] }}
boundary = [{{ name = "equator", path = "(5, 0) (20, 0) mm", condition = "symmetry" }},
  {{ name = "outer", path = "arc centre (0, 0) mm radius 20 mm from 0 deg to 90 deg", condition = "air" }},
  {{ name = "axis", path = "(0, 5) mm", condition = "symmetry" }},
  {{ name = "inner", path = "arc centre (0, 0) mm radius 5 mm from 90 deg to 0 deg", condition = "air" }}]
)",
                                         time, pressure, time / 5, eta, divisions);
    const std::string folder = tests::absent_folder();
    const Scene scene = scene_of(text);
    const RunOutcome outcome = run_in_folder(scene, folder);
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    const auto& all = outcome.facts.checks;
    const auto check =
        std::find_if(all.begin(), all.end(), [](const Check& one) { return one.name == "flow_resolution"; });
    const double off = write_summary(folder, scene, outcome.state, outcome.facts).thickness.mean / wall - 1;
    std::printf("%d divisions: wall off by %.4f, flow_resolution %.4f\n", divisions, off, check->value);
    return std::pair{off, check->verdict()};
  };
  EXPECT_EQ(blown(2).second, Verdict::beyond);
  const auto [off, verdict] = blown(4);
  EXPECT_LT(std::abs(off), 3e-3);
  EXPECT_EQ(verdict, Verdict::inside);
}

TEST(Checks, each_tells_of_its_own_number_and_of_no_other_also_where_it_is_no_number) {
  const Scene scene = scene_of(small_scene);
  const RunOutcome whole = run(scene, {}, {});
  ASSERT_TRUE(whole.facts.completed) << whole.facts.reason;
  const Checks untouched = checks(scene, whole.state, whole.facts);
  ASSERT_EQ(complaints(untouched), std::vector<std::string>{});
  std::set<std::string> told;
  for (const auto& [name, spoil] : spoilt_numbers)
    for (const double size : {0.5, std::numeric_limits<double>::quiet_NaN()}) {
      RunOutcome outcome = whole;
      spoil(outcome.state, outcome.facts, size);
      const auto sentences = complaints(checks(scene, outcome.state, outcome.facts));
      ASSERT_EQ(sentences.size(), 1u) << name << " by " << size;
      EXPECT_EQ(sentences[0].rfind(std::string(name) + " is ", 0), 0u) << sentences[0];
      told.insert(name);
    }
  for (const Check& check : untouched) EXPECT_TRUE(told.count(check.name)) << check.name << " was not spoilt";
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

TEST(Checks, glass_that_passes_its_plane_of_symmetry_is_told) {
  // The upper half of a shell: pressure from outside closes the hole and presses the glass on through the plane.
  const std::string text = R"(case = "collapse"
geometry = "axisymmetric"
stage = [{ name = "press", duration = "1.5 s", pressure.outer = "0.2 bar" }]
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
[glass]
material = "liquid"
mesh = { mapped = [3, 24] }
boundary = [{ name = "equator", path = "(10, 0) (12, 0) mm", condition = "symmetry" },
  { name = "outer", path = "arc centre (0, 0) mm radius 12 mm from 0 deg to 90 deg", condition = "air" },
  { name = "axis", path = "(0, 10) mm", condition = "symmetry" },
  { name = "inner", path = "arc centre (0, 0) mm radius 10 mm from 90 deg to 0 deg", condition = "air" }]
)";
  const auto of_axis = [](const RunOutcome& outcome) {
    return *std::find_if(outcome.facts.checks.begin(), outcome.facts.checks.end(),
                         [](const Check& check) { return check.name == "axis"; });
  };
  const auto collapsed = run_in_folder(scene_of(text), tests::absent_folder());
  EXPECT_GT(of_axis(collapsed).value, 0.1);
  EXPECT_FALSE(trustworthy(collapsed.facts.checks));
  const auto shrunk = run_in_folder(scene_of(replaced("1.5 s", "20 ms", text)), tests::absent_folder());
  EXPECT_LT(of_axis(shrunk).value, 1e-9);
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
  const auto [coarse, wrong_work] = coupling("max_step = \"50 ms\"\ntemperature_per_step = \"1000 K\"");
  EXPECT_EQ(fine.verdict(), Verdict::inside);
  EXPECT_GT(std::abs(wrong_work / work - 1), 0.02);
  EXPECT_NE(coarse.verdict(), Verdict::inside);
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
