// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/scene/materials/material_library.hpp"

namespace parison::forming {
namespace {

const std::string soft = R"([material.soft]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
viscosity = { law = "constant", value = "1e4 Pa.s" }
)";
/// The small scene with air, which a glass that radiates asks for.
const std::string airy = replaced("geometry = \"axisymmetric\"\n",
                                  "geometry = \"axisymmetric\"\nair = { temperature = \"50 degC\", h = \"20 W/m2/K\", "
                                  "ambient = \"50 degC\" }\n");
const std::string bundled = replaced("material = \"soft\"", "material = \"flint\"", replaced(soft, "", airy));

/// The scene with iron that light of the glass can reach.
std::string emitting(const std::string& text) {
  return replaced("[glass]\n", "emissivity = 0.8\n[glass]\n", text);
}

std::string with_viscosity(const std::string& viscosity) {
  return replaced("viscosity = { law = \"constant\", value = \"1e4 Pa.s\" }", "viscosity = " + viscosity);
}

const NamedMaterial& material(const std::string& name) {
  for (const NamedMaterial& found : library_materials())
    if (found.name == name) return found;
  throw std::runtime_error(name);
}

/// A point of a viscosity that a certificate, a standard or a data sheet gives.
struct KnownPoint {
  const char* glass;
  double temperature, log10_viscosity;  ///< degC, Pa.s
  double slack;                         ///< degC
};

TEST(Materials, viscosity_of_each_glass_goes_through_its_published_points) {
  const std::vector<KnownPoint> points{
      {"flint", 731, 6.6, 0.5},        {"flint", 565, 12, 0.5},        {"DGG_I", 1301, 1.5, 0.5},
      {"DGG_I", 721, 6.6, 0.5},        {"DGG_I", 539, 12, 0.5},        {"NIST_710A", 1319, 1.5, 0.5},
      {"NIST_710A", 731, 6.6, 0.5},    {"NIST_710A", 545, 12, 0.5},    {"borosilicate", 1260, 3, 0.5},
      {"borosilicate", 825, 6.6, 0.5}, {"borosilicate", 560, 12, 0.5}, {"float", 722, 6.6, 8}};
  for (const KnownPoint& point : points) {
    const flow::Viscosity& law = material(point.glass).flow->viscosity;
    const double T = point.temperature + 273.15;
    EXPECT_GE(std::log10(law(T - point.slack)), point.log10_viscosity - 1e-9) << point.glass << point.temperature;
    EXPECT_LE(std::log10(law(T + point.slack)), point.log10_viscosity) << point.glass << point.temperature;
  }
}

TEST(Materials, each_says_what_it_is_and_where_its_values_come_from) {
  EXPECT_GE(library_materials().size(), 16u);
  for (const NamedMaterial& found : library_materials()) {
    EXPECT_FALSE(found.about.empty()) << found.name;
    EXPECT_FALSE(found.source.empty()) << found.name;
    ASSERT_TRUE(found.thermal) << found.name;
    EXPECT_EQ(library_entry(found.name).rfind("[" + found.name + "]\n", 0), 0u) << found.name;
  }
}

TEST(Materials, each_assumed_value_of_a_bundled_one_has_its_range_and_reason) {
  int count = 0;
  for (const NamedMaterial& found : library_materials())
    for (const AssumedValue& value : found.assumed) {
      EXPECT_GE(value.range.size(), 8u) << found.name << " " << value.key;
      ++count;
    }
  EXPECT_GT(count, 0);
}

TEST(Materials, a_case_that_names_a_bundled_one_has_its_values_without_a_table) {
  const Scene scene =
      scene_of(replaced("material = \"iron\"", "material = \"grey_iron\"",
                        replaced(iron, "",
                                 replaced("[[tool]]\nname = \"plunger\"\nmaterial = \"iron\"",
                                          "[[tool]]\nname = \"plunger\"\nmaterial = \"grey_iron\"", bundled))));
  EXPECT_EQ(scene.glass.flow->viscosity.B, 3922);
  EXPECT_EQ(scene.glass.emissivity, 0.89);
  EXPECT_EQ(scene.glass.thermal->radiation->bands.front().absorption, 35);
  EXPECT_NEAR(scene.tools[0].emissivity, 0.64 + 0.14 * (scene.tools[0].initial_temperature - 473.15) / 400, 1e-12);
  EXPECT_EQ(scene.tools[0].thermal->conductivity(700), 46);
}

TEST(Materials, one_of_the_case_goes_before_a_bundled_one_of_its_name) {
  const std::string own =
      replaced("[material.soft]", "[material.flint]", replaced("material = \"soft\"", "material = \"flint\""));
  EXPECT_EQ(scene_of(own).glass.flow->viscosity.constant, 1e4);
  EXPECT_EQ(scene_of(own).glass.emissivity, 0);
}

TEST(Materials, one_like_a_bundled_one_has_its_own_values_and_the_rest_of_that) {
  const Scene scene =
      scene_of(emitting(replaced(soft,
                                 "[material.soft]\nlike = \"flint\"\nemissivity = 0.5\nviscosity = { law = "
                                 "\"constant\", value = \"1e4 Pa.s\" }\n",
                                 airy)));
  EXPECT_EQ(scene.glass.emissivity, 0.5);
  EXPECT_EQ(scene.glass.flow->viscosity.constant, 1e4);
  EXPECT_EQ(scene.glass.flow->surface_tension, 0.315);
  EXPECT_EQ(scene.glass.thermal->radiation->refractive_index, 1.518);
}

TEST(Materials, set_changes_a_value_of_a_bundled_one_and_the_glass_itself) {
  const auto folder = write_scene(emitting(bundled));
  EXPECT_EQ(read_scene(folder, "draft", {"material.flint.emissivity=0.7"}).glass.emissivity, 0.7);
  EXPECT_EQ(read_scene(folder, "draft", {"material.flint.viscosity.T0=300 degC"}).glass.flow->viscosity.T0, 573.15);
  const Scene green = read_scene(folder, "draft", {"glass.material=green"});
  EXPECT_EQ(green.glass.thermal->radiation->bands.front().absorption, 198);
  EXPECT_NE(green.fingerprint, read_scene(folder, "draft").fingerprint);
}

TEST(Materials, only_glasses_are_named_where_a_glass_is_unknown) {
  const auto said = complaint_about(replaced("material = \"soft\"", "material = \"flint_glass\""));
  EXPECT_NE(said.find("\"flint_glass\" was found (did you mean \"flint\"?), allowed are"), said.npos) << said;
  EXPECT_NE(said.find("borosilicate"), said.npos) << said;
  EXPECT_EQ(said.find("aluminium_bronze"), said.npos) << said;
}

TEST(Materials, mistakes_have_their_sentence) {
  const auto unknown = complaint_about(replaced("material = \"soft\"", "material = \"flnt\""));
  EXPECT_NE(unknown.find("glass.material: \"flnt\" was found (did you mean \"flint\"?), allowed are"), unknown.npos)
      << unknown;
  const auto like = complaint_about(replaced(soft, "[material.soft]\nlike = \"flnt\"\n"));
  EXPECT_NE(like.find("material.soft.like: \"flnt\" was found (did you mean \"flint\"?)"), like.npos) << like;
  const auto part = complaint_about(replaced("[glass]", "[material.flint]\nemissivity = 0.5\n[glass]", bundled));
  EXPECT_NE(part.find("material.flint: the density is missing; to change single values of the bundled material, add "
                      "like = \"flint\""),
            part.npos)
      << part;
  const auto assumed = complaint_about(replaced(soft, soft + "assumed = [\"colour\"]\n", small_scene));
  EXPECT_NE(assumed.find("material.soft.assumed: \"colour\" was found"), assumed.npos) << assumed;
  const auto range = complaint_about(replaced(soft, soft + "assumed.colour = \"green to blue\"\n", small_scene));
  EXPECT_NE(range.find("material.soft.assumed.colour: unknown key"), range.npos) << range;
  EXPECT_EQ(complaint_about(replaced(soft, soft + "assumed.density = \"2300 to 2500 kg/m3\"\n", small_scene)), "");
}

TEST(Materials, viscosity_by_points_is_read_and_its_mistakes_are_told) {
  const Scene scene =
      scene_of(with_viscosity(R"({ law = "table", points = [["700 degC", "1e7 Pa.s"], ["1000 degC", "1e3 Pa.s"]] })"));
  EXPECT_NEAR(scene.glass.flow->viscosity(1273.15) / 1e3, 1, 1e-12);
  const auto about = [](const std::string& points) {
    return complaint_about(with_viscosity("{ law = \"table\", points = " + points + " }"));
  };
  EXPECT_NE(about(R"([["700 degC", "1e7 Pa.s"]])").find("one point was found, allowed are two or more"),
            std::string::npos);
  EXPECT_NE(about(R"([["700 degC", "1e3 Pa.s"], ["900 degC", "1e4 Pa.s"]])")
                .find("10000 Pa.s is not below the 1000 Pa.s before it"),
            std::string::npos);
  EXPECT_NE(about(R"([["900 degC", "1e4 Pa.s"], ["700 degC", "1e3 Pa.s"]])").find("allowed are rising entries"),
            std::string::npos);
  EXPECT_NE(about("\"1e4 Pa.s\"").find("allowed is a list in brackets"), std::string::npos);
}

TEST(Materials, viscosity_by_composition_is_read_and_refused_outside_its_range) {
  const auto given = [](const std::string& oxides) {
    return with_viscosity("{ law = \"composition\", oxides = { " + oxides + " } }");
  };
  const Scene scene = scene_of(
      given(R"(SiO2 = "71.72 %", Al2O3 = "1.23 %", Na2O = "14.95 %", K2O = "0.38 %", CaO = "6.73 %", MgO = "4.18 %")"));
  EXPECT_NEAR(std::log10(scene.glass.flow->viscosity(1026.7 + 273.15)), 3, 0.02);
  const auto srm_710a = complaint_about(
      given(R"(SiO2 = "67.9 %", Al2O3 = "2.11 %", Na2O = "8.09 %", K2O = "9.34 %", CaO = "8.54 %", ZnO = "3.62 %")"));
  EXPECT_NE(srm_710a.find("oxides.Na2O: 8.09 % was found, allowed are 10 to 17 %, the range of the glasses"),
            srm_710a.npos)
      << srm_710a;
  const auto sum = complaint_about(given(R"(SiO2 = "70 %", Na2O = "14 %", CaO = "10 %")"));
  EXPECT_NE(sum.find("the oxides add up to 94 %, allowed are 98 to 100.5 %"), sum.npos) << sum;
  const auto oxide = complaint_about(given(R"(SiO2 = "70 %", Na2O = "14 %", CaO = "10 %", Fe2O3 = "6 %")"));
  EXPECT_NE(oxide.find("oxides.Fe2O3: unknown key"), oxide.npos) << oxide;
  const auto missing = complaint_about(given(R"(SiO2 = "75 %", Na2O = "15 %", K2O = "8 %")"));
  EXPECT_NE(missing.find("oxides.CaO: missing"), missing.npos) << missing;
}

}  // namespace
}  // namespace parison::forming
