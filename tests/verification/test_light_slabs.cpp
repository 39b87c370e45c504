// SPDX-License-Identifier: GPL-3.0-or-later
// Four slabs of glass that cool for seconds, between tools and open, by the coupled run at standard. The reference is
// the radiative transfer equation in one dimension by discrete ordinates (24 directions split at the critical angle,
// 160 cells, steps of 2 ms), the models' equations solved on the same cells.
#include <gtest/gtest.h>

#include <cstdio>

#include "figure.hpp"
#include "forming/run/run.hpp"
#include "forming/scene_text.hpp"

namespace parison::forming {
namespace {

constexpr double celsius = 273.15, width = 1e-3;

/// A slab's history: temperatures in degC, heat transfer in W/m2/K, lengths in mm.
struct Slab {
  const char* name;
  double thickness, start, duration;
  double lower_tool, upper_tool, h;  ///< 0: that side is open
  double surroundings;               ///< of the light, and the air
};
const Slab slabs[] = {{"dwell", 8, 1100, 1.7, 460, 500, 2000, 50},
                      {"hold", 3, 870, 3.5, 450, 0, 1000, 700},
                      {"reheat", 8, 1000, 1.6, 0, 0, 0, 50},
                      {"thin wall", 3, 900, 2, 0, 0, 0, 50}};

/// What a slab has at its end: degC, kJ/m2. With one skin for both sides `upper` is that of the lower.
struct End {
  double mean, lower, upper, conducted, radiated;
};

std::string tool_of(const char* name, double temperature, double low, double high, double h, bool above) {
  const char* far = "condition.temperature";
  return fmt::format(R"([[tool]]
name = "{0}"
material = "plate"
temperature = "{1} degC"
boundary = [{{ name = "low", path = "(0, {2}) (1, {2}) mm", {5} }}, {{ name = "right", path = "(1, {3}) mm", condition = "symmetry" }},
  {{ name = "high", path = "(0, {3}) mm", {6} }}, {{ name = "left", path = "(0, {2}) mm", condition = "symmetry" }}]
[[interface]]
tools = ["{0}"]
law = "constant"
h = "{4} W/m2/K"
)",
                     name, temperature, low, high, h,
                     above ? "condition = \"contact\"" : fmt::format("{} = \"{} degC\"", far, temperature),
                     above ? fmt::format("{} = \"{} degC\"", far, temperature) : "condition = \"contact\"");
}

/// The tools conduct so well and store so much that they keep their temperature.
std::string case_of(const Slab& slab, const std::string& radiation) {
  std::string text = fmt::format(R"(case = "slab"
geometry = "planar"
air = {{ temperature = "{0} degC", h = "20 W/m2/K", ambient = "{0} degC" }}
[material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
emissivity = 0.89
radiation = {1}
[material.plate]
density = "7200 kg/m3"
heat_capacity = "1e6 J/kg/K"
conductivity = "1e5 W/m/K"
emissivity = 0.8
[glass]
material = "glass"
temperature = "{2} degC"
boundary = [{{ name = "low", path = "(0, 0) (1, 0) mm", condition = "contact" }},
  {{ name = "right", path = "(1, {3}) mm", condition = "symmetry" }}, {{ name = "high", path = "(0, {3}) mm", condition = "contact" }},
  {{ name = "left", path = "(0, 0) mm", condition = "symmetry" }}]
)",
                                 slab.surroundings, radiation, slab.start, slab.thickness);
  std::string tools;
  if (slab.lower_tool > 0) text += tool_of("lower", slab.lower_tool, -5, 0, slab.h, false), tools += "\"lower\"";
  if (slab.upper_tool > 0)
    text += tool_of("upper", slab.upper_tool, slab.thickness, slab.thickness + 5, slab.h, true), tools += ", \"upper\"";
  return text + fmt::format("[[stage]]\nname = \"cool\"\nduration = \"{} s\"\ntools = [{}]\n", slab.duration, tools);
}

End run_slab(const Slab& slab, const std::string& radiation) {
  const Scene scene = scene_of(case_of(slab, radiation), "standard");
  const RunOutcome outcome = run(scene, {}, {});
  const GlassState& glass = outcome.state.glass;
  End end{0, 0, 0, 0, 0};
  end.mean = core::integral(glass.mesh, scene.geometry, glass.temperature, [](double T) { return T; }) /
                 (width * 1e-3 * slab.thickness) -
             celsius;
  for (Index i = 0; i < glass.mesh.node_count(); ++i) {
    if (glass.mesh.nodes[i][1] < 1e-9) end.lower = glass.temperature[i] - celsius;
    if (glass.mesh.nodes[i][1] > 1e-3 * slab.thickness - 1e-9) end.upper = glass.temperature[i] - celsius;
  }
  const Totals& totals = outcome.state.totals;
  end.radiated = totals.light_to_air;
  for (const ToolState& tool : outcome.state.tools) end.radiated += tool.heat_radiated;
  end.conducted = totals.to_air + totals.to_tools - end.radiated;
  end.radiated *= 1e-3 / width;
  end.conducted *= 1e-3 / width;
  return end;
}

struct Glass {
  const char* name;
  const char* bands;
  End p1[4], transfer[4];  ///< by slab
};

const Glass glasses[] = {
    {"grey",
     R"([{ absorption = "150 1/m" }])",
     {{1000.8, 698, 723, 2081, 395},
      {757.4, 632, 811, 843, 211},
      {980.2, 967, 967, 60, 435},
      {860.7, 855, 855, 66, 302}},
     {{1004.1, 697, 722, 2085, 309},
      {766.5, 637, 822, 855, 114},
      {984.9, 974, 974, 60, 318},
      {876.2, 870, 870, 67, 156}}},
    {"flint",
     R"([{ up_to = "2.75 um", absorption = "30 1/m" }, { up_to = "4.3 um", absorption = "450 1/m" }])",
     {{1006.7, 692, 717, 2049, 280},
      {760.9, 631, 814, 836, 185},
      {983.1, 947, 947, 59, 364},
      {862.3, 845, 845, 66, 287}},
     {{1009.4, 692, 717, 2053, 208},
      {764.8, 633, 820, 840, 145},
      {986.0, 952, 952, 59, 291},
      {868.2, 851, 851, 66, 232}}},
    {"amber",
     R"([{ up_to = "2.75 um", absorption = "400 1/m" }, { up_to = "4.3 um", absorption = "700 1/m" }])",
     {{1003.9, 702, 727, 2089, 311},
      {754.7, 632, 802, 839, 241},
      {980.5, 940, 940, 58, 428},
      {854.2, 836, 836, 65, 364}},
     {{1004.2, 698, 723, 2082, 309},
      {758.0, 632, 808, 840, 209},
      {981.6, 945, 945, 59, 401},
      {859.3, 842, 842, 65, 316}}}};

/// Largest differences in mean, skins and heat, the last in percent of all heat.
struct Difference {
  tests::Figure mean, skin, heat;

  explicit Difference(const std::string& what)
      : mean(what + ": mean off by", "K"), skin(what + ": skins off by", "K"), heat(what + ": all heat off by", "%") {}
  void add(const End& found, const End& reference) {
    mean.add(std::abs(found.mean - reference.mean));
    skin.add(std::max(std::abs(found.lower - reference.lower), std::abs(found.upper - reference.upper)));
    const double all = reference.conducted + reference.radiated;
    heat.add(100 * std::abs((found.conducted + found.radiated) / all - 1));
  }
};

std::string with_model(const char* model, const Glass& glass) {
  return fmt::format("{{ model = \"{}\", refractive_index = 1.518, bands = {} }}", model, glass.bands);
}

void print(const Slab& slab, const Glass& glass, const End& found) {
  std::printf("%-10s %-6s mean %.1f, skins %.1f %.1f, conducted %.0f, radiated %.0f\n", slab.name, glass.name,
              found.mean, found.lower, found.upper, found.conducted, found.radiated);
}

TEST(LightSlabs, P1_in_the_coupled_run_gives_the_temperatures_and_heats_of_its_equations) {
  for (const Glass& glass : glasses) {
    Difference equations(fmt::format("slabs of {} glass, P1 at standard against P1 in one dimension", glass.name));
    Difference model("the same against radiative transfer");
    for (int i = 0; i < 4; ++i) {
      const End found = run_slab(slabs[i], with_model("p1", glass));
      print(slabs[i], glass, found);
      equations.add(found, glass.p1[i]);
      model.add(found, glass.transfer[i]);
    }
    equations.mean.at_most(3);
    equations.skin.at_most(5);
    equations.heat.at_most(4);
    for (const tests::Figure* figure : {&model.mean, &model.skin, &model.heat}) figure->for_comparison();
  }
}

TEST(LightSlabs, P1_in_cones_gives_the_temperatures_and_heats_of_radiative_transfer) {
  for (const Glass& glass : glasses) {
    Difference model(fmt::format("slabs of {} glass, P1 in cones at standard against radiative transfer", glass.name));
    for (int i = 0; i < 4; ++i) {
      const End found = run_slab(slabs[i], with_model("p1_cones", glass));
      print(slabs[i], glass, found);
      model.add(found, glass.transfer[i]);
    }
    model.mean.at_most(3);
    model.skin.at_most(5);
    model.heat.at_most(4);
  }
}

TEST(LightSlabs, transfer_gives_the_temperatures_and_heats_of_the_reference) {
  for (const Glass& glass : glasses) {
    Difference model(
        fmt::format("slabs of {} glass, transfer by rays at standard against discrete ordinates", glass.name));
    for (int i = 0; i < 4; ++i) {
      const End found = run_slab(slabs[i], with_model("transfer", glass));
      print(slabs[i], glass, found);
      model.add(found, glass.transfer[i]);
    }
    model.mean.at_most(3);
    model.skin.at_most(5);
    model.heat.at_most(4);
  }
}

}  // namespace
}  // namespace parison::forming
