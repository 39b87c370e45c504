// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {
namespace {

const std::string cases = std::string(PARISON_SOURCE_DIR) + "/cases/";
const std::string drawn_glass = R"(boundary = [
  { name = "surface", path = "(0, 0) (20, 0) (20, 10) (0, 10) mm", condition = "contact" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
])";

Scene jar_with(const std::string& gob) {
  return read_scene(cases + "jar", "draft",
                    {"glass={ material = \"flint\", temperature = \"1150 degC\", gob = " + gob + " }"});
}

std::string complaint_about_jar_with(const std::string& gob) {
  try {
    jar_with(gob);
  } catch (const core::CaseError& error) {
    return error.what();
  }
  return "";
}

double volume_of(const Scene& scene) {
  return outline_volume(scene.glass.profile, scene.geometry);
}

/// kg/m3 of flint between 573 degC and some temperature, degC.
double flint_density(double celsius) {
  return 2520 * std::exp(-3 * (9e-6 * 553 + 32e-6 * (celsius - 573)));
}

TEST(ContainerPlan, the_plunger_of_the_jar_stops_where_its_gob_fills_the_cavity) {
  const auto plan = plan_container(read_scene(cases + "jar", "draft"));
  ASSERT_TRUE(plan && plan->press && plan->capacity);
  // 91.52 cm3 stop it at 92 mm; it is 27 mm thick where it enters the cavity.
  EXPECT_NEAR(1e3 * plan->press->stop, 92 - 1e3 * (0.22 / flint_density(1150) - 91.52e-6) / (M_PI * 0.027 * 0.027),
              0.01);
  EXPECT_NEAR(plan->press->cavity, plan->glass_volume, 1e-4 * plan->glass_volume);
  EXPECT_NEAR(*plan->capacity + plan->glass_volume, *plan->outside, 1e-12);
}

TEST(ContainerPlan, a_pressed_tumbler_holds_what_its_plunger_displaces) {
  auto scene = read_scene(cases + "tumbler", "draft", {"output.fill_level=10 mm"});
  const auto plan = plan_container(scene);
  ASSERT_TRUE(plan && plan->press && plan->filled);
  // 115.85 cm3 stop it at 8 mm; a wall of the ring is 32 mm from the axis.
  EXPECT_NEAR(1e3 * plan->press->stop, 8 + 1e3 * (0.278 / flint_density(1100) - 115.85e-6) / (M_PI * 0.032 * 0.032),
              0.05);
  EXPECT_NEAR(1e3 * *plan->rim, 90, 1e-6);
  EXPECT_FALSE(plan->outside);
  // Between the heights 82 and 90 mm the plunger's radius grows from 31.53 to 32 mm.
  EXPECT_NEAR(1e6 * (*plan->capacity - *plan->filled), M_PI * 3.2 * 3.2, 0.7);
}

TEST(ContainerPlan, a_heavier_gob_stops_the_plunger_earlier_by_its_volume_over_the_area_at_the_rim) {
  const auto at = [](const char* mass) {
    return plan_container(
               jar_with("{ mass = \"" + std::string(mass) + "\", diameter = \"52 mm\", at = \"(0, 20) mm\" }"))
        ->press->stop;
  };
  const double moved = at("219.6 g") - at("222 g");
  EXPECT_NEAR(moved * M_PI * 0.027 * 0.027, 2.4e-3 / flint_density(1150),
              1e-9);  // the plunger is 27 mm thick where it enters the cavity
}

TEST(ContainerPlan, where_no_capacity_is_known_a_line_says_why) {
  const auto text = [](const std::string& name, const std::vector<std::string>& overrides) {
    return describe_container(read_scene(cases + name, "draft", overrides));
  };
  const std::string open = text("bottle", {"stage.blow.tools=[\"ring\", \"mould\"]"});
  EXPECT_NE(
      open.find("capacity            not known before a run: the tools leave the mouth or another opening of their "
                "cavity open in the last stage, \"blow\", and no press cavity gives the inside; a run measures it"),
      open.npos)
      << open;
  const std::string floating = text("jar", {"stage.hold.gravity=0 m/s2"});
  EXPECT_NE(floating.find("not known: the last stage, \"hold\", has no gravity"), floating.npos) << floating;
  const std::string wrong = text("tumbler", {"stage.press.motion.plunger.force=10 kN"});
  EXPECT_NE(wrong.find("press cavity        none found: from where \"plunger\" starts, in the direction of its force, "
                       "the drawings close none with the other tools of stage \"press\""),
            wrong.npos)
      << wrong;
  EXPECT_EQ(text("sag", {}).find("capacity"), std::string::npos) << "no container is formed";
}

TEST(Gob, a_capsule_has_its_mass_and_its_pole) {
  const Scene scene = jar_with("{ mass = \"219.6 g\", diameter = \"52 mm\", at = \"(0, 20) mm\" }");
  EXPECT_NEAR(flint_density(1150) * volume_of(scene), 0.2196, 2e-5 * 0.2196);
  EXPECT_EQ(scene.glass.profile.segments.front().start, core::Point(0, 0.02));
  const Scene sphere =
      scene_of(replaced(drawn_glass, "gob = { mass = \"20 g\", diameter = \"25.153 mm\", at = \"(0, 0) mm\" }"));
  EXPECT_NEAR(2400 * volume_of(sphere), 0.02, 1e-4 * 0.02);
}

TEST(Gob, an_outline_is_scaled_to_the_mass_about_its_lower_pole) {
  const Scene scene = scene_of(replaced(drawn_glass, "gob.mass = \"15 g\"\n" + drawn_glass));
  EXPECT_NEAR(2400 * volume_of(scene), 0.015, 1e-9);
  const double factor = std::cbrt(0.015 / (2400 * M_PI * 4e-6));
  EXPECT_NEAR(core::size(scene.glass.profile), factor * std::hypot(0.02, 0.01), 1e-12);
  EXPECT_EQ(scene.glass.profile.segments.front().start, core::Point(0, 0));
}

TEST(Gob, its_skin_is_as_cold_as_given_and_its_core_warm) {
  const State state = initial_state(
      scene_of(replaced("temperature = \"1000 degC\"",
                        "temperature = \"1000 degC\"\nskin = { temperature = \"900 degC\", depth = \"1 mm\" }")));
  const auto& nodes = state.glass.mesh.nodes;
  double coldest = 1e9;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double depth = std::min({nodes[i][1], 0.01 - nodes[i][1], 0.02 - nodes[i][0]});
    EXPECT_NEAR(state.glass.temperature[static_cast<Index>(i)], 1273.15 - 100 * std::exp(-depth / 1e-3), 1e-6);
    coldest = std::min(coldest, state.glass.temperature[static_cast<Index>(i)]);
  }
  EXPECT_NEAR(coldest, 1173.15, 1e-6);
}

TEST(Gob, one_that_does_not_fit_is_refused_with_what_fits) {
  const auto heavy = complaint_about_jar_with("{ mass = \"900 g\", diameter = \"50 mm\", at = \"(0, 20) mm\" }");
  EXPECT_NE(heavy.find("glass.gob: 900 g of glass have 383.2 cm3, but the cavity of stage \"press\" has at most 2"),
            heavy.npos)
      << heavy;
  const auto light = complaint_about_jar_with("{ mass = \"150 g\", diameter = \"40 mm\", at = \"(0, 20) mm\" }");
  EXPECT_NE(light.find("cm3, but the cavity of stage \"press\" has at least "), light.npos) << light;
  EXPECT_NE(light.find("(with \"plunger\" at 98 mm, where it meets \"blank\"); allowed is a mass that fits"),
            light.npos)
      << light;
}

TEST(Gob, a_plunger_that_starts_too_far_in_is_blamed_and_not_the_mass) {
  const auto with_position = [](const char* position) -> std::string {
    try {
      read_scene(cases + "uneven", "draft", {"tool.plunger.position=" + std::string(position)});
    } catch (const core::CaseError& error) {
      return error.what();
    }
    return "";
  };
  const std::string inside = with_position("110 mm");
  EXPECT_NE(inside.find("(with \"plunger\" at 110 mm): that tool starts inside \"blank\", beyond 91.07 mm, where the "
                        "cavity is full; allowed is a `position` of \"plunger\" below 91.07 mm, or a mass that fits"),
            inside.npos)
      << inside;
  const std::string beyond = with_position("95 mm");
  EXPECT_NE(beyond.find("that tool starts beyond 91.07 mm, where the cavity is full"), beyond.npos) << beyond;
}

TEST(Gob, one_that_overlaps_the_plunger_is_told_the_position_with_which_it_does_not) {
  const auto with_position = [](const char* position) -> std::string {
    try {
      read_scene(cases + "uneven", "draft",
                 {"tool.plunger.position=" + std::string(position),
                  "glass.gob={ mass = \"220 g\", diameter = \"52 mm\", at = \"(0, 20) mm\" }"});
    } catch (const core::CaseError& error) {
      return error.what();
    }
    return "";
  };
  const std::string overlap = with_position("36.9 mm");
  EXPECT_NE(overlap.find("\"plunger\" overlaps the glass at the start by "), overlap.npos) << overlap;
  EXPECT_NE(overlap.find("; with `position = \"20 mm\"` in place of 36.9 mm the tool would not"), overlap.npos)
      << overlap;
  EXPECT_EQ(with_position("20 mm"), "");
}

TEST(Gob, mistakes_have_their_sentences) {
  const auto with = [](const std::string& gob) {
    const auto text = complaint_about(replaced(drawn_glass, gob));
    return text.substr(text.find(' ') + 1);
  };
  EXPECT_EQ(with("gob = { mass = \"20 g\", diameter = \"44 mm\", at = \"(0, 0) mm\" }"),
            "glass.gob.diameter: a sphere of 44 mm has more than the gob's 8.333 cm3, allowed is a diameter of up to "
            "25.15 mm");
  EXPECT_EQ(with("gob = { mass = \"20 g\", diameter = \"1 mm\", at = \"(0, 0) mm\" }"),
            "glass.gob.diameter: the gob would be 10.6 m long, allowed are up to 100 diameters");
  EXPECT_EQ(with("gob = { mass = \"20 mm\", diameter = \"20 mm\", at = \"(0, 0) mm\" }"),
            "glass.gob.mass: \"20 mm\" is a length, allowed is a mass such as \"220 g\"");
  EXPECT_EQ(with("gob = { mass = \"20 g\", diameter = \"20 mm\", at = \"(3, 0) mm\" }"),
            "glass.gob.at: \"(3, 0) mm\" was found, allowed are points on the axis");
  EXPECT_EQ(with("gob = { mass = \"20 g\", at = \"(0, 0) mm\" }"),
            "glass.gob.diameter: missing, the table that starts here needs the key \"diameter\"");
  EXPECT_EQ(with("gob = { mass = \"20 g\", diameter = \"20 mm\" }\n" + drawn_glass),
            "glass.gob.diameter: a diameter and a boundary were found, allowed is one of them");
  EXPECT_EQ(with("gob.mass = \"1e9 t\"\n" + drawn_glass),
            "glass.gob.mass: a gob of 4.17e+14 cm3 was found, allowed are volumes from 1e-09 to 1e+09 cm3");
  EXPECT_EQ(with("skin.temperature = \"900 degC\"\n" + drawn_glass),
            "glass.skin.depth: missing, the table that starts here needs the key \"depth\"");
}

}  // namespace
}  // namespace parison::forming
