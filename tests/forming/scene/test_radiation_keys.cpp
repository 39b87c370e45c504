// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <limits>

#include "../scene_text.hpp"
#include "forming/run/run.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/materials/material_library.hpp"
#include "forming/study/model_variants.hpp"
#include "thermal/radiation/fresnel.hpp"

namespace parison::forming {
namespace {

/// The small scene with air, radiation in its glass and a surface of the tools.
std::string text_with(const std::string& radiation, const std::string& tools = "emissivity = 0.8\n") {
  const std::string air = "air = { temperature = \"50 degC\", h = \"20 W/m2/K\", ambient = \"50 degC\" }\n";
  const std::string lattice = "conductivity = \"1.3 W/m/K\"\n";
  return replaced(
      "[material.soft]", air + "[material.soft]",
      replaced("[glass]\n", tools + "[glass]\n", replaced(lattice, lattice + "radiation = { " + radiation + " }\n")));
}

/// The complaint without its line.
std::string complaint(const std::string& radiation, const std::string& tools = "emissivity = 0.8\n") {
  const auto message = complaint_about(text_with(radiation, tools));
  return message.substr(message.find(' ') + 1);
}

std::string bands(const std::string& list) {
  return "model = \"p1\", refractive_index = 1.5, bands = " + list;
}

TEST(RadiationKeys, bands_are_read_and_a_last_one_without_end_has_the_rest_of_the_spectrum) {
  const Scene scene = scene_of(text_with(
      bands(R"([{ up_to = "2.75 um", absorption = "30 1/m" }, { up_to = "4300 nm", absorption = "450 1/m" }])")));
  ASSERT_TRUE(scene.has_light());
  const thermal::Radiation& radiation = *scene.glass.thermal->radiation;
  ASSERT_EQ(radiation.bands.size(), 2u);
  EXPECT_DOUBLE_EQ(radiation.bands[0].up_to, 2.75e-6);
  EXPECT_DOUBLE_EQ(radiation.bands[1].up_to, 4.3e-6);
  EXPECT_EQ(radiation.bands[1].absorption, 450);
  EXPECT_EQ(radiation.refractive_index, 1.5);
  EXPECT_DOUBLE_EQ(scene.glass.emissivity, thermal::surface_emissivity(1.5));
  EXPECT_EQ(scene.tools[0].emissivity, 0.8);
  const Scene grey = scene_of(text_with(bands(R"([{ absorption = "150 1/m" }])")));
  EXPECT_TRUE(std::isinf(grey.glass.thermal->radiation->bands[0].up_to));
}

TEST(RadiationKeys, bands_may_be_those_of_a_bundled_glass_by_name) {
  const auto absorption = [](const char* name) {
    const Scene scene = scene_of(text_with(bands(fmt::format("\"{}\"", name))));
    const auto& of_glass = scene.glass.thermal->radiation->bands;
    EXPECT_EQ(of_glass.size(), 2u);
    return of_glass.front().absorption;
  };
  EXPECT_LT(absorption("flint"), absorption("green"));
  EXPECT_LT(absorption("green"), absorption("amber"));
  EXPECT_NE(complaint(bands("\"flnt\""))
                .find("allowed are DGG_I, NIST_710A, amber, borosilicate, crystal, flint, float, green"),
            std::string::npos)
      << complaint(bands("\"flnt\""));
}

TEST(RadiationKeys, without_a_model_radiation_is_that_of_Rosseland_and_none_is_none) {
  const std::string keys = "refractive_index = 1.5, absorption = \"150 1/m\", thin_wall = true";
  EXPECT_TRUE(thermal::is_rosseland(*scene_of(text_with(keys)).glass.thermal));
  EXPECT_TRUE(thermal::is_rosseland(*scene_of(text_with("model = \"rosseland\", " + keys)).glass.thermal));
  EXPECT_FALSE(scene_of(text_with("model = \"none\"")).glass.thermal->radiation);
  const std::string both = keys + R"(, bands = [{ absorption = "150 1/m" }])";
  EXPECT_TRUE(scene_of(text_with("model = \"p1\", " + both)).has_light());
  EXPECT_TRUE(scene_of(text_with("model = \"p1_cones\", " + both)).has_light());
  EXPECT_TRUE(scene_of(text_with("model = \"transfer\", " + both)).has_light());
  EXPECT_FALSE(scene_of(text_with("model = \"rosseland\", " + both)).has_light());
}

TEST(RadiationKeys, bands_that_fall_or_absorb_impossibly_are_refused_with_the_range) {
  EXPECT_NE(
      complaint(bands(R"([{ up_to = "4 um", absorption = "30 1/m" }, { up_to = "3 um", absorption = "30 1/m" }])"))
          .find("up_to: \"3 um\" was found, allowed are wavelengths above 4 um, where the band before ends"),
      std::string::npos);
  for (const char* bad : {"-30", "0", "1e5"})
    EXPECT_NE(complaint(bands(std::string("[{ absorption = \"") + bad + " 1/m\" }]"))
                  .find(std::string("absorption: \"") + bad +
                        " 1/m\" was found, allowed are 0.1 to 2000 1/m; a glass "
                        "that absorbs more is opaque: end the bands before it"),
              std::string::npos)
        << bad;
  EXPECT_NE(complaint(bands("[]")).find("bands: 0 bands were found, allowed are 1 to 20"), std::string::npos);
  EXPECT_NE(complaint(bands(R"([{ absorption = "30 1/m" }, { up_to = "3 um", absorption = "30 1/m" }])")).find("up_to"),
            std::string::npos);
  EXPECT_NE(complaint(bands(R"([{ upto = "3 um", absorption = "30 1/m" }])")).find("did you mean \"up_to\"?"),
            std::string::npos);
}

TEST(RadiationKeys, absorption_may_be_a_table_over_temperature) {
  const std::string table = R"([["800 degC", "30 1/m"], ["1000 degC", "45 1/m"], ["1300 degC", "90 1/m"]])";
  const std::string list = "[{ up_to = \"2.75 um\", absorption = " + table + " }, { absorption = \"450 1/m\" }]";
  const Scene scene = scene_of(text_with(bands(list)));
  const auto& of_glass = scene.glass.thermal->radiation->bands;
  EXPECT_TRUE(thermal::absorption_varies(*scene.glass.thermal));
  EXPECT_NEAR(of_glass[0].absorption * of_glass[0].relative(1273.15), 45, 1e-12);
  EXPECT_NEAR(of_glass[0].absorption * of_glass[0].relative(2000), 90, 1e-12);
  EXPECT_TRUE(of_glass[1].relative.x.empty());
  EXPECT_NE(describe_scene(scene).find("P1, 2 bands, absorption by temperature"), std::string::npos);
  const std::string mean = "refractive_index = 1.5, thin_wall = true, absorption = ";
  const Scene rosseland = scene_of(text_with(mean + table));
  EXPECT_FALSE(thermal::absorption_varies(*rosseland.glass.thermal));
  const auto k = [](const Scene& of, double T) { return thermal::conductivity(*of.glass.thermal, T); };
  const double alone = rosseland.glass.thermal->conductivity(1273.15);
  EXPECT_NEAR((k(rosseland, 1273.15) - alone) / (k(scene_of(text_with(mean + "\"45 1/m\"")), 1273.15) - alone), 1,
              1e-12);
}

TEST(RadiationKeys, a_table_that_is_empty_falls_or_absorbs_impossibly_is_refused_with_its_line) {
  const auto refused = [](const std::string& table) {
    const std::string message =
        complaint_about(text_with(bands("[{ up_to = \"2.75 um\", absorption = " + table + " }]")));
    EXPECT_NE(message.find("absorption"), std::string::npos) << message;
    EXPECT_TRUE(std::isdigit(message[0])) << message;
    return message;
  };
  EXPECT_NE(refused("[]").find("an empty list was found"), std::string::npos);
  EXPECT_NE(refused(R"([["1000 degC", "30 1/m"], ["900 degC", "40 1/m"]])").find("does not lie above the entry before"),
            std::string::npos);
  EXPECT_NE(refused(R"([["900 degC", "30 1/m"], ["1000 degC", "-4 1/m"]])")
                .find("\"-4 1/m\" was found, allowed are 0.1 to 2000 1/m"),
            std::string::npos);
  EXPECT_NE(refused(R"([["900 degC", "30 1/m", "2"]])").find("3 members were found"), std::string::npos);
  EXPECT_NE(refused(R"([["30 1/m", "900 degC"]])").find("30 1/m"), std::string::npos);
  EXPECT_NE(
      complaint("refractive_index = 1.5, thin_wall = true, absorption = [[\"900 degC\", \"0 1/m\"]]").find("0 1/m"),
      std::string::npos);
}

TEST(RadiationKeys, an_index_below_one_and_an_unknown_model_are_refused) {
  EXPECT_NE(complaint(R"(model = "p1", refractive_index = 0.9, bands = [{ absorption = "150 1/m" }])")
                .find("refractive_index: 0.9 was found, allowed are refractive indices from 1"),
            std::string::npos);
  EXPECT_NE(complaint("model = \"p3\", refractive_index = 1.5").find("p1_cones"), std::string::npos)
      << complaint("model = \"p3\", refractive_index = 1.5");
  EXPECT_NE(complaint("model = \"p1\", refractive_index = 1.5").find("bands"), std::string::npos);
}

TEST(RadiationKeys, a_tool_that_light_reaches_needs_an_emissivity) {
  EXPECT_NE(complaint(bands(R"([{ absorption = "150 1/m" }])"), "")
                .find("tool.material: \"iron\" has no emissivity, allowed is a material with one, because light of the "
                      "glass reaches the tool"),
            std::string::npos);
  EXPECT_EQ(complaint("refractive_index = 1.5, absorption = \"150 1/m\", thin_wall = true", ""), "");
}

/// The complaint about such a scene whose surfaces see each other.
std::string complaint_with_enclosure(const std::string& radiation, const std::string& tools = "emissivity = 0.8\n",
                                     const std::string& value = "true") {
  const auto message = complaint_about("enclosure = " + value + "\n" + text_with(radiation, tools));
  return message.substr(message.find(' ') + 1);
}

TEST(RadiationKeys, an_enclosure_needs_surfaces_that_emit_and_a_model_that_light_can_cross) {
  const std::string band = R"(refractive_index = 1.5, bands = [{ absorption = "150 1/m" }])";
  EXPECT_EQ(complaint_with_enclosure("model = \"transfer\", " + band), "");
  EXPECT_TRUE(scene_of("enclosure = true\n" + text_with("model = \"transfer\", " + band)).enclosure);
  EXPECT_TRUE(scene_of(text_with("model = \"transfer\", " + band)).enclosure)
      << "surfaces of light by rays see each other";
  EXPECT_FALSE(scene_of("enclosure = false\n" + text_with("model = \"transfer\", " + band)).enclosure);
  EXPECT_FALSE(scene_of(text_with("model = \"p1\", " + band)).enclosure);
  for (const char* model : {"p1", "p1_cones"})
    EXPECT_NE(complaint_with_enclosure(std::string("model = \"") + model + "\", " + band)
                  .find("enclosure: true was found with the radiation of the glass by P1, allowed with the models "
                        "transfer, rosseland and none"),
              std::string::npos);
  EXPECT_NE(complaint_with_enclosure("model = \"none\"")
                .find("enclosure: true was found with a glass that has no emissivity, allowed is a material with one"),
            std::string::npos);
  EXPECT_NE(complaint_with_enclosure("model = \"transfer\", " + band, "")
                .find("tool.material: \"iron\" has no emissivity, allowed is a material with one, because light of the "
                      "glass reaches the tool"),
            std::string::npos);
  EXPECT_NE(complaint_with_enclosure("model = \"none\"", "emissivity = 0.8\n", "\"yes\"").find("enclosure"),
            std::string::npos);
}

TEST(RadiationKeys, glass_with_bands_and_no_model_has_its_light_by_rays) {
  const Scene scene = scene_of(text_with(R"(refractive_index = 1.5, bands = [{ absorption = "150 1/m" }])"));
  EXPECT_TRUE(scene.glass.thermal->radiation->model == thermal::Radiation::Model::transfer);
  EXPECT_TRUE(scene.enclosure);
  ASSERT_TRUE(scene.radiation_choice);
  EXPECT_EQ(scene.radiation_choice->model.name, "transfer");
  EXPECT_NE(complaint(R"(refractive_index = 1.5, bands = [{ absorption = "150 1/m" }])", "").find("has no emissivity"),
            std::string::npos);
}

TEST(RadiationKeys, an_emissivity_over_temperature_is_that_of_the_start_of_the_tool) {
  const std::string light = bands(R"([{ absorption = "150 1/m" }])");
  const Scene scene = scene_of(text_with(light, "emissivity = [[\"0 degC\", 0.2], [\"1000 degC\", 0.7]]\n"));
  const double start = scene.tools[0].initial_temperature - 273.15;
  EXPECT_NEAR(scene.tools[0].emissivity, 0.2 + 0.5 * start / 1000, 1e-12);
  EXPECT_NE(complaint(light, "emissivity = [[\"0 degC\", 0.2], [\"900 degC\", 1.2]]\n")
                .find("1.2 was found, allowed is 0 to 1"),
            std::string::npos);
}

TEST(RadiationKeys, conduction_in_place_of_bands_has_their_mean_absorption) {
  const auto conducted = [](const char* material, double celsius) {
    thermal::Material glass{2400, core::constant(1300), core::constant(1.3), {}};
    for (const NamedMaterial& known : library_materials())
      if (known.name == material) glass = *known.thermal;
    glass.radiation->model = thermal::Radiation::Model::rosseland;
    return thermal::conductivity(glass, celsius + 273.15) - glass.conductivity(celsius + 273.15);
  };
  // Genzel 1952, measured at 1200 degC on a clear and on an absorbing glass, W/m/K.
  EXPECT_NEAR(conducted("flint", 1200), 46.5, 0.15 * 46.5);
  EXPECT_NEAR(conducted("green", 1200), 8.1, 0.3 * 8.1);
  const core::Table grey = thermal::rosseland_absorption({{std::numeric_limits<double>::infinity(), 150}});
  for (const double kappa : grey.y) EXPECT_NEAR(kappa, 150, 1e-3);
}

TEST(RadiationKeys, light_needs_surroundings) {
  const std::string lit = text_with(bands(R"([{ absorption = "150 1/m" }])"));
  const std::string dark =
      replaced("air = { temperature = \"50 degC\", h = \"20 W/m2/K\", ambient = \"50 degC\" }\n", "", lit);
  EXPECT_NE(complaint_about(dark).find("stage.air: missing"), std::string::npos) << complaint_about(dark);
}

TEST(RadiationKeys, check_names_transfer_and_the_audit_puts_the_cheaper_model_in_its_place) {
  const std::string text =
      "enclosure = false\n" +
      text_with(
          R"(model = "transfer", refractive_index = 1.5, bands = [{ up_to = "2.75 um", absorption = "30 1/m" }])");
  const Scene scene = scene_of(text);
  EXPECT_NE(describe_scene(scene).find("radiative transfer along rays, 1 band, opaque beyond 2.75 um"),
            std::string::npos);
  int found = 0;
  for (const Variant& variant : model_variants(scene)) {
    if (variant.name != "p1_cones") continue;
    ++found;
    const Scene changed = read_scene(write_scene(text), "draft", variant.overrides);
    EXPECT_TRUE(changed.glass.thermal->radiation->model == thermal::Radiation::Model::p1_cones);
  }
  EXPECT_EQ(found, 1);
}

TEST(RadiationKeys, transfer_is_refused_without_its_index_bands_and_emissivity_of_the_tools) {
  const std::string band = R"(bands = [{ absorption = "150 1/m" }])";
  EXPECT_NE(complaint("model = \"transfer\", " + band).find("refractive_index"), std::string::npos);
  EXPECT_NE(complaint("model = \"transfer\", refractive_index = 1.5").find("bands"), std::string::npos);
  EXPECT_NE(complaint("model = \"transfer\", refractive_index = 0.9, " + band)
                .find("0.9 was found, allowed are refractive indices from 1"),
            std::string::npos);
  EXPECT_NE(complaint("model = \"transfer\", refractive_index = 1.5, " + band, "").find("has no emissivity"),
            std::string::npos);
}

TEST(RadiationKeys, check_names_the_model_and_the_audit_takes_it_out) {
  const std::string text = text_with("absorption = \"150 1/m\", thin_wall = true, " +
                                     bands(R"([{ up_to = "2.75 um", absorption = "30 1/m" }])"));
  const Scene scene = scene_of(text);
  EXPECT_NE(describe_scene(scene).find("P1, 1 band, opaque beyond 2.75 um"), std::string::npos);
  int found = 0;
  for (const Variant& variant : model_variants(scene)) {
    if (variant.name != "no_radiation" && variant.name != "rosseland") continue;
    ++found;
    const Scene changed = read_scene(write_scene(text), "draft", variant.overrides);
    EXPECT_EQ(thermal::is_rosseland(*changed.glass.thermal), variant.name == "rosseland");
    EXPECT_FALSE(changed.has_light());
    EXPECT_NEAR(changed.glass.emissivity, scene.glass.emissivity, 1e-5);
  }
  EXPECT_EQ(found, 2);
}

TEST(RadiationKeys, an_enclosure_between_planes_of_symmetry_that_show_many_images_is_refused) {
  const std::string plate =
      "geometry = \"axisymmetric\"\nenclosure = true\n"
      "stage = [{ name = \"rest\", duration = \"1 s\" }]\n"
      "air = { temperature = \"50 degC\", h = \"20 W/m2/K\", ambient = \"50 degC\" }\n"
      "case = \"plate\"\n[glass]\nmaterial = \"flint\"\ntemperature = \"1000 degC\"\n";
  const auto ring = [&](const std::string& top) {
    return plate +
           "boundary = [{ name = \"bottom\", path = \"(10, 0) (20, 0) mm\", condition = \"symmetry\" }, "
           "{ name = \"outer\", path = \"(20, 10) mm\", condition = \"air\" }, "
           "{ name = \"top\", path = \"(10, 10) mm\", condition = \"" +
           top +
           "\" }, "
           "{ name = \"inner\", path = \"(10, 0) mm\", condition = \"air\" }]\n";
  };
  EXPECT_EQ(complaint_about(ring("air")), "");
  EXPECT_NE(complaint_about(ring("symmetry"))
                .find("enclosure: true was found with 2 planes of symmetry across the axis, allowed are one, or two at "
                      "right angles"),
            std::string::npos)
      << complaint_about(ring("symmetry"));
}

}  // namespace
}  // namespace parison::forming
