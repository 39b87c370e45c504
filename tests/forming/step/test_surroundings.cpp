// SPDX-License-Identifier: GPL-3.0-or-later
// Air inside and outside, cooling of tools by stage, and curves over the time of a stage, on bodies so conductive that
// each has one temperature.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "../scene_text.hpp"
#include "forming/run/run.hpp"

namespace parison::forming {
namespace {

/// A ring of 6 to 8 mm radius and 10 mm height in air, and a tool apart from it with a cooled bore.
const std::string ring = R"(case = "ring"
geometry = "axisymmetric"
air = { temperature = "100 degC", h = "50 W/m2/K", ambient = "100 degC" }
MORE
[material.block]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1e5 W/m/K"
[glass]
material = "block"
temperature = "1000 degC"
boundary = [
  { name = "rest", condition = "air", path = "(6, 0) (8, 0) (8, 10) (6, 10) mm" },
  { name = "inner", condition = "air", path = "(6, 0) mm" } ]
[[tool]]
name = "core"
material = "block"
temperature = "500 degC"
boundary = [
  { name = "bore", condition.cooled = { h = "400 W/m2/K", temperature = "50 degC" }, path = "(2, 30) (2, 20) mm" },
  { name = "shell", condition = "insulated", path = "(4, 20) (4, 30) (2, 30) mm" } ]
[[stage]]
name = "first"
duration = "1 s"
FIRST
[[stage]]
name = "second"
duration = "2 s"
SECOND
)";

Scene ring_scene(const std::string& more, const std::string& first, const std::string& second) {
  Scene scene =
      scene_of(replaced("SECOND", second, replaced("FIRST", first, replaced("MORE", more, ring))), "standard");
  scene.accuracy.temperature_tolerance = 0.02;
  return scene;
}

using Rate = std::function<double(double time, double temperature)>;  ///< K/s

/// The temperature after a time by the classical Runge-Kutta rule in steps of 50 us, which meet every corner.
double integrated(const Rate& rate, double temperature, double from, double to) {
  const double dt = 5e-5;
  for (long i = 0; i < std::lround((to - from) / dt); ++i) {
    const double t = from + static_cast<double>(i) * dt, a = rate(t, temperature),
                 b = rate(t + dt / 2, temperature + dt / 2 * a), c = rate(t + dt / 2, temperature + dt / 2 * b),
                 d = rate(t + dt, temperature + dt * c);
    temperature += dt / 6 * (a + 2 * b + 2 * c + d);
  }
  return temperature;
}

constexpr double stored = 2400 * 1300;  // J/m3/K
/// The areas of the ring over its volume, 1/m.
constexpr double ring_volume = 28e-6 * 10e-3, inside = 2 * 6e-3 * 10e-3 / ring_volume,
                 outside = (2 * 8e-3 * 10e-3 + 2 * 28e-6) / ring_volume;
/// Of the bore of the core.
constexpr double bore = 2 * 2e-3 * 10e-3 / (12e-6 * 10e-3);

struct Temperatures {
  double glass, core;  ///< K
};

Temperatures at_end(const Scene& scene) {
  const RunOutcome outcome = run(scene, {});
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  const auto& glass = outcome.state.glass.temperature;
  const auto& core = outcome.state.tools[0].temperature;
  EXPECT_LT(glass.maxCoeff() - glass.minCoeff(), 0.05) << "the glass has one temperature";
  return {glass.mean(), core.mean()};
}

TEST(Surroundings, air_inside_acts_on_the_inner_side_alone_in_its_stage) {
  const double alone = at_end(ring_scene("", "", "")).glass;
  EXPECT_NEAR(alone, 373.15 + 900 * std::exp(-3 * 50 * (inside + outside) / stored), 0.02);
  const double blown =
      at_end(ring_scene("", "", R"(inner_air = { temperature = "600 degC", h = "900 W/m2/K", ambient = "600 degC" })"))
          .glass;
  const auto own = [](double, double T) {
    return -(50 * outside * (T - 373.15) + 900 * inside * (T - 873.15)) / stored;
  };
  const double first = 373.15 + 900 * std::exp(-50 * (inside + outside) / stored);
  EXPECT_NEAR(blown, integrated(own, first, 0, 2), 0.02);
  EXPECT_GT(std::abs(blown - alone), 5);
  const std::string common = R"(inner_air = { temperature = "600 degC", h = "900 W/m2/K", ambient = "600 degC" })";
  EXPECT_NEAR(at_end(ring_scene(common, "", "")).glass, integrated(own, 1273.15, 0, 3), 0.02);
}

TEST(Surroundings, air_of_a_stage_over_time_counts_from_its_start_and_no_short_gust_is_missed) {
  const std::string gust =
      R"(air = { ambient = "100 degC", temperature = [["0 s", "100 degC"], ["2 s", "300 degC"]], h = [["1.5 s", "0 W/m2/K"], ["1.51 s", "6000 W/m2/K"], ["1.56 s", "6000 W/m2/K"], ["1.57 s", "0 W/m2/K"]] })";
  const double found =
      at_end(ring_scene("", R"(air = { temperature = "100 degC", h = "0 W/m2/K", ambient = "100 degC" })", gust)).glass;
  const core::Table h{{1.5, 1.51, 1.56, 1.57}, {0, 6000, 6000, 0}};
  const Rate rate = [&](double t, double T) { return -h(t) * (inside + outside) * (T - (373.15 + 100 * t)) / stored; };
  const double exact = integrated(rate, 1273.15, 0, 2);
  std::printf("gust of 60 ms: %.4f K, exact %.4f K\n", found, exact);
  EXPECT_LT(exact, 1200);
  EXPECT_NEAR(found, exact, 0.1);
}

TEST(Surroundings, cooling_of_a_tool_goes_off_and_on_by_stage_and_over_its_time) {
  const double off = at_end(ring_scene("", "", "cooling.core = \"off\"")).core;
  const double first = 323.15 + 450 * std::exp(-400 * bore / stored);
  EXPECT_NEAR(off, first, 0.02);
  const double ramp = at_end(ring_scene("", "cooling.core = \"off\"",
                                        R"(cooling.core = { h = [["0 s", "0 W/m2/K"], ["2 s", "800 W/m2/K"]] })"))
                          .core;
  EXPECT_NEAR(ramp, 323.15 + 450 * std::exp(-800 * bore / stored), 0.05);
  const double warm =
      at_end(ring_scene("", "", R"(cooling.core.bore = { h = "400 W/m2/K", temperature = "400 degC" })")).core;
  EXPECT_NEAR(warm, 673.15 + (first - 673.15) * std::exp(-2 * 400 * bore / stored), 0.02);
}

TEST(Surroundings, where_the_glass_flows_the_same_holds) {
  const std::string flowing =
      "conductivity = \"1e5 W/m/K\"\nviscosity = { law = \"constant\", value = \"1e9 Pa.s\" }\n";
  const std::string text =
      replaced("conductivity = \"1e5 W/m/K\"\n", flowing,
               replaced("material = \"block\"\ntemperature = \"500 degC\"\n",
                        "material = \"block\"\ntemperature = \"500 degC\"\nfriction = \"slip\"\n", ring));
  const std::string gust =
      R"(cooling.core.bore = { temperature = "50 degC", h = [["1.5 s", "0 W/m2/K"], ["1.51 s", "6000 W/m2/K"], ["1.56 s", "6000 W/m2/K"], ["1.57 s", "0 W/m2/K"]] })";
  const Scene scene = scene_of(
      replaced("SECOND", gust, replaced("FIRST", "cooling.core = \"off\"", replaced("MORE", "", text))), "standard");
  EXPECT_NEAR(at_end(scene).core, 323.15 + 450 * std::exp(-6000 * 0.06 * bore / stored), 0.1);
}

std::string mistake(const std::string& more, const std::string& second) {
  const std::string said =
      complaint_about(replaced("SECOND", second, replaced("FIRST", "", replaced("MORE", more, ring))));
  return said.substr(said.find(' ') + 1);
}

TEST(Surroundings, mistakes_have_their_sentences) {
  EXPECT_EQ(mistake("", "cooling.cor = \"off\""),
            "stage.cooling.cor: \"cor\" was found (did you mean \"core\"?), allowed are core");
  EXPECT_EQ(mistake("", "cooling.core.shell = \"off\""),
            "stage.cooling.core.shell: \"shell\" was found, allowed are bore");
  EXPECT_EQ(mistake("", "cooling.core = \"of\""),
            "stage.cooling.core: \"of\" was found (did you mean \"off\"?), allowed are off");
  EXPECT_EQ(mistake("", "cooling.core.temperature = \"20 degC\""),
            "stage.cooling.core.h: missing, the table that starts here needs the key \"h\"");
  EXPECT_EQ(
      mistake("", "cooling.core.h = [[\"0 s\", \"-5 W/m2/K\"]]"),
      "stage.cooling.core.h: \"-5 W/m2/K\" was found, allowed is a heat transfer coefficient such as \"5000 W/m2/K\", "
      "not below zero");
  EXPECT_EQ(mistake("", "inner_air = { temperature = \"600 degC\", h = \"900 W/m2/K\" }"),
            "stage.inner_air.ambient: missing, the table that starts here needs the key \"ambient\"");
  const auto unnamed = replaced("name = \"inner\"", "name = \"hole\"", ring);
  const std::string air = "inner_air = { temperature = \"600 degC\", h = \"900 W/m2/K\", ambient = \"600 degC\" }";
  for (const auto& [more, second] : {std::pair<std::string, std::string>{air, ""}, {"", air}}) {
    const auto said =
        complaint_about(replaced("SECOND", second, replaced("FIRST", "", replaced("MORE", more, unnamed))));
    EXPECT_NE(
        said.find("inner_air: the glass has no inner side up to this stage, allowed where a plunger or a pin has left "
                  "it or a stage names a boundary \"inner\""),
        said.npos)
        << said;
  }
}

TEST(Surroundings, common_air_inside_names_the_inner_side_by_the_plunger_that_left) {
  const std::string air =
      "inner_air = { temperature = \"600 degC\", h = \"900 W/m2/K\", ambient = \"600 degC\" }\n[material.soft]";
  const std::string third = "[[stage]]\nname = \"reheat\"\nduration = \"1 s\"\ntools = [\"plate\"]\n[[probe]]";
  const Scene scene = scene_of(replaced("[material.soft]", air, replaced("[[probe]]", third)));
  ASSERT_EQ(scene.stages[2].named_boundaries.size(), 1u);
  EXPECT_EQ(scene.stages[2].named_boundaries[0].name, "inner");
  EXPECT_EQ(scene.stages[2].named_boundaries[0].touched, 1);
  EXPECT_TRUE(scene.stages[2].inner_air);
}

}  // namespace
}  // namespace parison::forming
