// SPDX-License-Identifier: GPL-3.0-or-later
// What the parts of the model are estimated to change, before a run.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../bundled_scene.hpp"
#include "../scene_text.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/describe/model_sensitivity.hpp"

namespace parison::forming {
namespace {

TEST(Accuracy, inertia_that_matters_is_warned_of) {
  const Scene jar = bundled("jar", "draft");
  EXPECT_EQ(describe_sensitivity(jar).find("warning"), std::string::npos);
  const Scene fast = bundled("shell_inflation", "draft", {"material.liquid.viscosity.value=1 Pa.s"});
  EXPECT_NE(describe_sensitivity(fast).find("warning: inertia is neglected"), std::string::npos);
}

const PartSensitivity& part(const std::vector<PartSensitivity>& parts, const std::string& name) {
  return *std::find_if(parts.begin(), parts.end(), [&](const PartSensitivity& p) { return p.name == name; });
}

TEST(Accuracy, held_tools_bring_standing_glass_the_heat_of_the_exact_solution) {
  // Two half-spaces, h 5000, 10 s, crystal glass on steel, by hand: 1.808 over 1.523.
  const auto parts = model_sensitivity(bundled("contact_cylinders", "draft"));
  EXPECT_NEAR(part(parts, "warming of tools").heat, 0.187, 0.002);
}

TEST(Accuracy, what_tools_press_on_both_sides_has_a_wall_of_theirs) {
  const auto blown = model_sensitivity(bundled("jar", "draft")),
             pressed = model_sensitivity(bundled("tumbler", "draft"));
  for (const char* name :
       {"surface tension", "gravity", "friction on tools", "internal radiation", "surface radiation"})
    EXPECT_LT(part(pressed, name).thickness, 0.1 * part(blown, name).thickness) << name;
  EXPECT_GT(part(pressed, "internal radiation").heat, 0.1);
}

TEST(Accuracy, what_has_no_time_changes_nothing_and_tools_that_stand_press_nothing) {
  const std::string sag =
      small_scene.substr(0, small_scene.find("[[stage]]\nname = \"press\"")) + "gravity = \"-9.81 m/s2\"\n";
  const auto at = [&](const char* duration, const std::string& more = "", const char* h = "2000") {
    std::string text = replaced("duration = \"1 s\"", fmt::format("duration = \"{}\"", duration), sag);
    text = replaced("h = \"2000 W/m2/K\"", fmt::format("h = \"{} W/m2/K\"", h), text);
    return model_sensitivity(scene_of(text + more));
  };
  for (const char* name :
       {"surface tension", "gravity", "friction on tools", "internal radiation", "warming of tools"}) {
    EXPECT_LT(part(at("1 ms"), name).thickness, 0.01) << name;
    EXPECT_GE(part(at("10 s"), name).thickness, part(at("1 ms"), name).thickness) << name;
  }
  const auto static_stage = at("0.5 s", "motion.plate = { offset = \"0 mm\" }\n"), still = at("0.5 s");
  EXPECT_EQ(part(static_stage, "gravity").thickness, part(still, "gravity").thickness);
  for (const auto& p : at("10 s", "", "1e-6")) EXPECT_TRUE(std::isfinite(p.heat) && p.heat < 1.001) << p.name;
}

TEST(Accuracy, parts_that_a_case_switches_off_are_called_neglected) {
  std::vector<std::string> slip{"material.flint.radiation.model=rosseland", "material.flint.radiation.thin_wall=false",
                                "air.h=0 W/m2/K"};
  for (const char* tool : {"ring", "plate", "blank", "plunger", "blow_mould"})
    slip.push_back(fmt::format("tool.{}.friction=slip", tool));
  const std::string text = describe_sensitivity(bundled("jar", "draft", slip));
  for (const char* name : {"thin-wall limit", "friction on tools", "cooling by air"})
    EXPECT_NE(text.find(fmt::format("  {:<20}neglected", name)), std::string::npos) << text;
  EXPECT_NE(text.find("parison tradeoff CASE --parts"), std::string::npos);
  EXPECT_EQ(text.find('%'), std::string::npos) << "no estimate that is not proved";
}

}  // namespace
}  // namespace parison::forming
