// SPDX-License-Identifier: GPL-3.0-or-later
// A disc that tools press: a quarter of it in space against the axisymmetric run of the same case.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <utility>

#include "forming/run/checkpoint.hpp"
#include "forming/run/run.hpp"
#include "forming/scene_text.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {
namespace {

const std::string disc =
    "case = \"disc\"\ngeometry = \"axisymmetric\"\n" + container_glass("10 W/m/K") + iron + R"([glass]
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
friction = "slip"
boundary = [
  { name = "top", path = "(40, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -10) mm", condition = "symmetry" },
  { name = "rest", path = "(40, -10) (40, 0) mm", condition = "insulated" },
]
[[tool]]
name = "plunger"
material = "iron"
temperature = "450 degC"
friction = "slip"
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
gravity = "-9.81 m/s2"
tools = ["plate"]
[[stage]]
name = "press"
duration = "0.2 s"
gravity = "-9.81 m/s2"
tools = ["plate", "plunger"]
motion.plunger = { offset = [["0 s", "8.1 mm"], ["0.2 s", "7 mm"]] }
)";

/// Of the whole turn, at the end.
struct Pressed {
  std::string end_reason;
  double end = 0, force = 0, heat = 0, radius = 0;  ///< s, N and J of the plunger, m of the glass
};

Pressed pressed(const std::string& text) {
  Scene scene = scene_of(text, "draft coarser 2");
  scene.accuracy.max_step = 2e-3;  // the force is that of the middle of the last step
  const RunOutcome outcome = run(scene);
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  Pressed result{outcome.facts.stages.back().end_reason, outcome.facts.stages.back().end};
  if (!outcome.solid) {
    const ToolState& plunger = outcome.state.tools[1];
    result.force = plunger.force;
    result.heat = plunger.heat_received;
    for (const Point& x : outcome.state.glass.mesh.nodes) result.radius = std::max(result.radius, x[0]);
    return result;
  }
  const SolidState& solid = *outcome.solid;
  result.force = -solid.tools[1].force[2] / solid.share;
  result.heat = solid.tools[1].heat_received / solid.share;
  for (const core::Vector3& x : solid.glass.mesh.nodes) result.radius = std::max(result.radius, x.head<2>().norm());
  return result;
}

std::string in_space(const std::string& text) {
  return replaced("name = \"press\"\n", "name = \"press\"\nsolid = { sector = \"90 deg\" }\n", text);
}

/// Both runs of a case: how and when they end, the force, the heat and the glass there agree.
Pressed expect_as_round(const std::string& what, const std::string& text) {
  const Pressed round = pressed(text);
  const Pressed solid = pressed(in_space(text));
  fmt::print(
      "{}: round {} at {:.5f} s, {:.4g} N, {:.5g} J, {:.5g} mm; in space {} at {:.5f} s, {:.4g} N, {:.5g} J, {:.5g} "
      "mm\n",
      what, round.end_reason, round.end, round.force, round.heat, 1e3 * round.radius, solid.end_reason, solid.end,
      solid.force, solid.heat, 1e3 * solid.radius);
  EXPECT_EQ(round.end_reason, solid.end_reason) << what;
  constexpr double allowed = 0.025;  // with cells twice as long as at draft
  EXPECT_NEAR(solid.end, round.end, allowed * round.end) << what;
  EXPECT_NEAR(solid.force, round.force, allowed * std::abs(round.force)) << what;
  EXPECT_NEAR(solid.heat, round.heat, allowed * round.heat) << what;
  EXPECT_NEAR(solid.radius, round.radius, allowed * round.radius) << what;
  return solid;
}

std::string with(const std::string& from, const std::string& to, const std::string& text = disc) {
  return replaced(from, to, text);
}

std::string ending(const std::string& condition) {
  return with("duration = \"0.2 s\"", "duration = \"0.2 s\"\nend = { " + condition + " }");
}

TEST(SolidAsRound, a_stage_in_space_ends_by_each_condition_when_the_round_one_does) {
  const std::string cold = "surface_below = \"900 degC\"";
  EXPECT_EQ(expect_as_round(cold, ending(cold)).end_reason, "surface below its temperature");
  // Where the plunger lands the share jumps, by a step in each run.
  const std::string filled = ending("filled = \"60 %\", within = \"0.02 mm\"");
  const Pressed round = pressed(filled), solid = pressed(in_space(filled));
  EXPECT_EQ(round.end_reason, "mould filled");
  EXPECT_EQ(solid.end_reason, "mould filled");
  EXPECT_NEAR(solid.end, round.end, 2e-3);
}

TEST(SolidAsRound, glass_that_thins_by_shear) {
  const std::string thinning =
      with("viscosity = { law", "shear_thinning = { time = \"0.5 s\", exponent = 0.4 }\nviscosity = { law");
  const double plain = pressed(disc).force;
  EXPECT_LT(std::abs(expect_as_round("shear thinning", thinning).force), 0.95 * std::abs(plain));
}

TEST(SolidAsRound, friction_at_coulombs_limit) {
  const std::string slides = "friction = { law = \"navier\", coefficient = \"1e8 Pa.s/m\", coulomb = 0.1 }";
  const std::string plate = with("friction = \"slip\"", slides);
  const double free = pressed(disc).force;
  EXPECT_GT(std::abs(expect_as_round("Coulomb", with("friction = \"slip\"", slides, plate)).force),
            1.1 * std::abs(free));
}

const std::string constant = "law = \"constant\"\nh = \"2000 W/m2/K\"";

TEST(SolidAsRound, contact_by_the_law_of_a_gap) {
  expect_as_round("gap", with(constant, "law = \"gap\""));
}

/// Keeps the last checkpoint within a stage in space.
struct Keeper : RunObserver {
  std::string folder;
  bool has_kept = false;
  explicit Keeper(std::string where) : folder(std::move(where)) {}
  void checkpoint_possible(const RunView& view, bool at_stage_boundary) override {
    if (!view.solid || at_stage_boundary) return;
    write_checkpoint(folder, view.scene, {{view.state, view.facts, view.solid}, {}});
    has_kept = true;
  }
};

/// A run, and what it is from the last such checkpoint on.
std::pair<RunOutcome, RunOutcome> run_and_resume(const std::string& text) {
  const Scene scene = scene_of(text, "draft coarser 2");
  Keeper keeper(tests::folder_of_test("kept").string());
  std::filesystem::create_directories(keeper.folder);
  RunOutcome whole = run(scene, {&keeper});
  EXPECT_TRUE(whole.facts.completed) << whole.facts.reason;
  EXPECT_TRUE(keeper.has_kept);
  RunOutcome again = resume(scene, read_checkpoint(find_checkpoint(keeper.folder), scene).outcome);
  return {std::move(whole), std::move(again)};
}

TEST(SolidAsRound, a_run_taken_up_again_in_space_is_the_same_to_the_last_bit) {
  std::string text =
      with("friction = \"slip\"", "friction = { law = \"navier\", coefficient = \"1e8 Pa.s/m\", coulomb = 0.2 }");
  text = with(constant, "law = \"gap\"", text);
  text = with("duration = \"0.2 s\"",
              "duration = \"0.2 s\"\nsolid = { sector = \"90 deg\" }\nend = { surface_below = \"850 degC\" }", text);
  const auto [whole, again] = run_and_resume(text);
  EXPECT_EQ(again.facts.stages.back().end, whole.facts.stages.back().end);
  EXPECT_EQ(again.facts.stages.back().end_reason, "surface below its temperature");
  const SolidState &one = *whole.solid, &other = *again.solid;
  EXPECT_EQ(one.glass.mesh.nodes, other.glass.mesh.nodes);
  EXPECT_EQ(one.glass.temperature, other.glass.temperature);
  EXPECT_EQ(one.contact_opening, other.contact_opening);
  EXPECT_GT(one.contact_opening.maxCoeff(), 0);
}

TEST(SolidAsRound, glass_that_cools_in_space_is_taken_up_again_to_the_last_bit) {
  std::string text = with("material = \"glass\"", "material = \"flint\"");
  for (int tool = 0; tool < 2; ++tool) text = with("material = \"iron\"", "material = \"grey_iron\"", text);
  text = text.substr(0, text.find("[[stage]]")) + R"([[stage]]
name = "rest"
duration = "50 ms"
gravity = "-9.81 m/s2"
tools = ["plate"]
[[stage]]
name = "cool"
kind = "cooling"
solid = { sector = "90 deg" }
duration = "100 s"
gravity = "-9.81 m/s2"
tools = ["plate"]
[air]
temperature = "20 degC"
h = "60 W/m2/K"
ambient = "20 degC"
)";
  const auto [whole, again] = run_and_resume(text);
  const SolidState &one = *whole.solid, &other = *again.solid;
  EXPECT_EQ(one.glass.mesh.nodes, other.glass.mesh.nodes);
  EXPECT_EQ(one.glass.temperature, other.glass.temperature);
  EXPECT_EQ(one.branch_stress, other.branch_stress);
  EXPECT_EQ(one.fictive_temperature, other.fictive_temperature);
  EXPECT_GT(one.branch_stress.cwiseAbs().maxCoeff(), 1e5);  // Pa
}

}  // namespace
}  // namespace parison::forming
