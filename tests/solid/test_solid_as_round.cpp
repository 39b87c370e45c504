// SPDX-License-Identifier: GPL-3.0-or-later
// A disc that tools press: a quarter of it in space against the axisymmetric run of the same case.
#include <gtest/gtest.h>

#include <cmath>

#include "figure.hpp"
#include "forming/run/run.hpp"
#include "forming/scene_text.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {
namespace {

const std::string disc = "case = \"disc\"\ngeometry = \"axisymmetric\"\n" + container_glass("1.3 W/m/K") + iron + R"([glass]
material = "glass"
temperature = "950 degC"
boundary = [
  { name = "surface", path = "(0, 0) (20, 0) (20, 8) (0, 8) mm", condition = "contact" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]
[[tool]]
name = "plate"
material = "iron"
temperature = "450 degC"
friction = "stick"
boundary = [
  { name = "top", path = "(40, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -10) mm", condition = "symmetry" },
  { name = "rest", path = "(40, -10) (40, 0) mm", condition = "insulated" },
]
[[tool]]
name = "plunger"
material = "iron"
temperature = "450 degC"
friction = "stick"
position = "8.1 mm"
boundary = [
  { name = "face", path = "(0, 0) (40, 0) mm", condition = "contact" },
  { name = "rest", path = "(40, 20) (0, 20) mm", condition = "insulated" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]
[[interface]]
tools = ["plate", "plunger"]
law = "constant"
h = "2000 W/m2/K"
[[stage]]
name = "rest"
duration = "50 ms"
tools = ["plate"]
[[stage]]
name = "press"
duration = "0.2 s"
tools = ["plate", "plunger"]
motion.plunger = { offset = [["0 s", "8.1 mm"], ["0.2 s", "6.6 mm"]] }
)";

/// Of the whole turn, at the end.
struct Pressed {
  std::string end_reason;
  double end = 0, force = 0, heat = 0, radius = 0;  ///< s, N and J of the plunger, m of the glass
};

Pressed pressed(const std::string& text) {
  const Scene scene = scene_of(text, "draft coarser 2");
  const RunOutcome outcome = run(scene);
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  Pressed result{outcome.facts.stages.back().end_reason, outcome.facts.stages.back().end, 0, 0, 0};
  if (!outcome.solid) {
    const ToolState& plunger = outcome.state.tools[1];
    result.force = plunger.end_force;
    result.heat = plunger.heat_received;
    for (const Point& x : outcome.state.glass.mesh.nodes) result.radius = std::max(result.radius, x[0]);
    return result;
  }
  const SolidState& solid = *outcome.solid;
  result.force = -solid.tools[1].end_force / solid.share;
  result.heat = solid.tools[1].heat_received / solid.share;
  for (const core::Vector3& x : solid.glass.mesh.nodes) result.radius = std::max(result.radius, x.head<2>().norm());
  return result;
}

/// Both runs of a case; their ends agree within `allowed`, the heat of the round one too, and their ways of ending.
Pressed expect_as_round(const std::string& what, const std::string& text, double allowed) {
  const Pressed round = pressed(text);
  const Pressed solid = pressed(replaced("name = \"press\"\n", "name = \"press\"\nsolid = { sector = \"90 deg\" }\n", text));
  fmt::print("{}: round {} at {:.5f} s, {:.4g} N, {:.5g} J, {:.5g} mm; in space {} at {:.5f} s, {:.4g} N, {:.5g} J, {:.5g} mm\n",
             what, round.end_reason, round.end, round.force, round.heat, 1e3 * round.radius, solid.end_reason, solid.end,
             solid.force, solid.heat, 1e3 * solid.radius);
  EXPECT_EQ(round.end_reason, solid.end_reason) << what;
  tests::Figure off("disc pressed in space against the round run, " + what + ": force, heat, radius and time off by");
  off.add(std::abs(solid.end / round.end - 1));
  off.add(std::abs(solid.force / round.force - 1));
  off.add(std::abs(solid.heat / round.heat - 1));
  off.add(std::abs(solid.radius / round.radius - 1));
  off.at_most(allowed);
  return solid;
}

std::string with(const std::string& from, const std::string& to, const std::string& text = disc) {
  return replaced(from, to, text);
}

TEST(SolidAsRound, a_stage_in_space_ends_by_each_condition_when_the_round_one_does) {
  for (const std::string end : {"force = \"1 kN\"", "filled = \"72 %\"", "surface_below = \"830 degC\""})
    EXPECT_NE(expect_as_round("end by " + end.substr(0, end.find(' ')),
                              with("duration = \"0.2 s\"", "duration = \"0.2 s\"\nend = { " + end + " }"), 0.02)
                  .end_reason,
              "duration");
}

TEST(SolidAsRound, glass_that_thins_by_shear) {
  const std::string thinning =
      with("viscosity = { law", "shear_thinning = { time = \"0.05 s\", exponent = 0.4 }\nviscosity = { law");
  const double plain = pressed(disc).force;
  EXPECT_LT(std::abs(expect_as_round("shear thinning", thinning, 0.02).force), 0.8 * std::abs(plain));
}

TEST(SolidAsRound, friction_at_coulombs_limit) {
  const std::string slides = "friction = { law = \"navier\", coefficient = \"1e8 Pa.s/m\", coulomb = 0.05 }";
  const std::string plate = with("friction = \"stick\"", slides);
  const double sticking = pressed(disc).force;
  EXPECT_LT(std::abs(expect_as_round("Coulomb", with("friction = \"stick\"", slides, plate), 0.02).force),
            0.9 * std::abs(sticking));
}

TEST(SolidAsRound, contact_by_the_law_of_a_gap) {
  const std::string gap = with("law = \"constant\"\nh = \"2000 W/m2/K\"", "law = \"gap\"");
  expect_as_round("gap", gap, 0.02);
}

}  // namespace
}  // namespace parison::forming
