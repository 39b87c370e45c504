// SPDX-License-Identifier: GPL-3.0-or-later
// The keys of a density that follows the temperature: what is read and what is refused.
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"

namespace parison::forming {
namespace {

const std::string expansion =
    R"(expansion = { cold_density = "2520 kg/m3", solid = "9e-6 1/K", liquid = "32e-6 1/K", transformation = "550 degC" })";

/// The small scene, its glass with other lines in the place of its density.
std::string with_density(const std::string& lines) {
  return replaced("density = \"2400 kg/m3\"\n", lines + "\n");
}

std::string points(const std::string& pairs) {
  return with_density("density = [" + pairs + "]");
}

double density_at(const Scene& scene, double celsius) {
  return scene.glass.density() * scene.glass.relative_density()(celsius + 273.15);
}

void expect_complaint(const std::string& text, const std::string& sentence) {
  const auto message = complaint_about(text);
  EXPECT_NE(message.find(sentence), message.npos) << message;
}

TEST(ExpansionKeys, a_table_over_temperature_is_the_density) {
  const Scene scene =
      scene_of(points(R"(["20 degC", "2520 kg/m3"], ["550 degC", "2480 kg/m3"], ["1200 degC", "2340 kg/m3"])"));
  EXPECT_TRUE(scene.expands());
  EXPECT_NEAR(density_at(scene, 20), 2520, 1e-9);
  EXPECT_NEAR(density_at(scene, 875), 2410, 1e-9);
  EXPECT_NEAR(scene.glass.density(), density_at(scene, 1000), 1e-9) << "the density is that at the start";
  EXPECT_NEAR(scene.glass.flow->density, scene.glass.thermal->density, 1e-12);
}

TEST(ExpansionKeys, coefficients_give_the_density_in_place_of_one_value) {
  const Scene scene = scene_of(with_density(expansion));
  EXPECT_NEAR(density_at(scene, 20), 2520, 1e-3);
  EXPECT_NEAR(density_at(scene, 500), 2520 * std::exp(-3 * 9e-6 * 480), 1e-3);
  EXPECT_NEAR(density_at(scene, 1000), 2520 * std::exp(-3 * (9e-6 * 530 + 32e-6 * 450)), 1e-3);
  EXPECT_FALSE(scene_of(with_density("density = \"2400 kg/m3\"\n" + expansion)).expands()) << "one value goes before";
}

TEST(ExpansionKeys, a_gob_by_its_mass_has_the_volume_of_its_temperature) {
  const std::string outline = R"(boundary = [
  { name = "surface", path = "(0, 0) (20, 0) (20, 10) (0, 10) mm", condition = "contact" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
])";
  const std::string text =
      replaced(outline, "gob = { mass = \"30 g\", diameter = \"25 mm\", at = \"(0, 0) mm\" }", with_density(expansion));
  const Scene scene = scene_of(replaced("position = \"10 mm\"", "position = \"40 mm\"", text));
  const double volume = outline_volume(scene.glass.profile, scene.geometry);
  EXPECT_NEAR(volume * density_at(scene, 1000), 0.03, 1e-6);  // of the outline as a polygon
  EXPECT_GT(volume, 1.05 * 0.03 / 2520);
  expect_complaint(
      replaced("temperature = \"1000 degC\"",
               "temperature = \"1000 degC\"\nskin = { temperature = \"900 degC\", depth = \"1 mm\" }", text),
      "glass.skin: a gob by its mass was found with a density over temperature, allowed is one temperature");
}

TEST(ExpansionKeys, what_no_glass_does_is_refused) {
  expect_complaint(
      points(R"(["20 degC", "2400 kg/m3"], ["1200 degC", "2500 kg/m3"])"),
      "material.soft.density: 2500 kg/m3 is above the 2400 kg/m3 before it, allowed are densities that fall");
  expect_complaint(
      points(R"(["20 degC", "2500 kg/m3"], ["1200 degC", "1500 kg/m3"])"),
      "material.soft.density: the glass would expand by 0.000144 1/K in length from 20 degC, allowed is up "
      "to 0.0001 1/K");
  expect_complaint(points(R"(["20 degC", "2500 kg/m3"])"), "material.soft.density: 1 pairs were found, allowed are 2");
  expect_complaint(
      points(R"(["500 degC", "2500 kg/m3"], ["1200 degC", "2400 kg/m3"])"),
      "glass.material: the density of the glass is given from 500 to 1200 degC, allowed are tables from 20 "
      "to 1000 degC");
  expect_complaint(points(R"(["20 degC", "2500 kg/m3"], ["900 degC", "2400 kg/m3"])"),
                   "allowed are tables from 20 to 1000");
  expect_complaint(with_density(replaced("32e-6", "-32e-6", expansion)),
                   "material.soft.expansion.liquid: \"-32e-6 1/K\" was found");
  expect_complaint(with_density(replaced("32e-6", "32e-5", expansion)),
                   "expansion.liquid: 0.00032 1/K was found, allowed is up to");
  expect_complaint(with_density(replaced("550 degC", "5 degC", expansion)),
                   "expansion.transformation: \"5 degC\" was found");
  expect_complaint(
      replaced("density = \"7200 kg/m3\"", R"(density = [["20 degC", "7200 kg/m3"], ["1200 degC", "7100 kg/m3"]])"),
      "tool.material: \"iron\" has a density over temperature, which only the glass can have");
}

}  // namespace
}  // namespace parison::forming
