// SPDX-License-Identifier: GPL-3.0-or-later
// Checks of the flow: divisions across a wall, the plane of symmetry, the cap of the viscosity.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../../scene_text.hpp"
#include "../slipping_press.hpp"
#include "forming/report/checks/checks.hpp"
#include "forming/report/summary.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/run/run.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/penetration.hpp"

namespace parison::forming {
namespace {

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
    const double off = write_summary(folder, scene, outcome).thickness.mean / wall - 1;
    std::printf("%d divisions: wall off by %.4f, flow_resolution %.4f\n", divisions, off, check->value);
    return std::pair{off, check->verdict()};
  };
  EXPECT_EQ(blown(2).second, Verdict::beyond);
  const auto [off, verdict] = blown(4);
  EXPECT_LT(std::abs(off), 3e-3);
  EXPECT_EQ(verdict, Verdict::inside);
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

/// A puddle of glass on a plate whose face ends below it, at a ring without contact.
const std::string puddle_on_ledge = R"(case = "ledge"
geometry = "axisymmetric"
[material.soft]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
[glass]
material = "soft"
boundary = [
  { name = "bottom", path = "(0, 0) (20, 0) (20, 10) mm", condition = "contact" },
  { name = "top", path = "(0, 10) mm", condition = "air" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" } ]
[[tool]]
name = "plate"
friction = "stick"
boundary = [
  { name = "rest", path = "(0, -10) (40, -10) mm", condition = "insulated" },
  { name = "ledge", path = "(40, 0) (10, 0) mm", condition = "insulated" },
  { name = "face", path = "(0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -10) mm", condition = "symmetry" } ]
[[stage]]
name = "rest"
duration = "0.2 s"
gravity = "-9.81 m/s2"
tools = ["plate"]
)";

TEST(Checks, glass_that_enters_a_tool_through_a_face_without_contact_is_told_with_tool_and_boundary) {
  const auto told = [](const std::string& text) {
    const Scene scene = scene_of(text);
    std::string all;
    for (const std::string& sentence : complaints(run(scene).facts.checks)) all += sentence + "\n";
    return all;
  };
  const std::string said = told(puddle_on_ledge);
  EXPECT_NE(said.find("penetration is "), said.npos) << said;
  EXPECT_NE(said.find("glass has entered tool plate through its boundary ledge, which has no contact"), said.npos)
      << said;
  EXPECT_EQ(said.find("strain_per_step"), said.npos) << said;
  const std::string held = told(
      replaced("(10, 0) mm\", condition = \"insulated\"", "(10, 0) mm\", condition = \"contact\"", puddle_on_ledge));
  EXPECT_EQ(held.find("penetration"), held.npos) << held;
}

TEST(Penetration, glass_behind_a_face_without_contact_is_as_deep_as_it_is_behind_that_face) {
  const Scene scene = scene_of(puddle_on_ledge);
  const auto pushed = [&](double radius, double depth) {
    State state = initial_state(scene);
    for (Point& x : state.glass.mesh.nodes)
      if (x[1] == 0 && x[0] > radius) x[1] -= depth;
    GlassInTools seen;
    follow_glass_in_tools(scene, state, seen);
    return seen;
  };
  const GlassInTools entered = pushed(15e-3, 50e-6);
  EXPECT_NEAR(entered.node.depth, 50e-6, 1e-12) << "the contact face is 5 mm away";
  EXPECT_LT(50e-6, 0.01 * core::mean_wall(initial_state(scene).glass.mesh)) << "thick glass";
  EXPECT_NE(entered_face_sentence(scene, entered).find("tool plate through its boundary ledge"), std::string::npos);
  EXPECT_EQ(entered_face_sentence(scene, pushed(15e-3, 1e-6)), "") << "round-off";
}

TEST(Penetration, a_place_where_a_contact_boundary_ends_at_one_without_contact_is_told) {
  const Scene scene = scene_of(puddle_on_ledge);
  const auto told_of_node_at = [&](std::size_t corner, double radius) {
    State state = initial_state(scene);
    core::Mesh& mesh = state.glass.mesh;
    for (const Index node : mesh.cells()[0]) mesh.nodes[node] = {5e-3, 3e-3};
    mesh.nodes[mesh.cells()[0][corner]] = {radius, 0};
    return end_of_contact(scene, state, 0);
  };
  for (std::size_t corner = 0; corner < 3; ++corner) {
    EXPECT_EQ(told_of_node_at(corner, 10e-3),
              ", where contact boundary face of plate ends at its boundary ledge, which has no contact");
    EXPECT_EQ(told_of_node_at(corner, 9e-3), "");
    EXPECT_EQ(told_of_node_at(corner, 0), "") << "the axis is no such boundary";
  }
}

TEST(Checks, a_run_that_stops_after_glass_has_entered_a_tool_says_that_first) {
  const Scene scene =
      scene_of(puddle_on_ledge + "[[stage]]\nname = \"cool\"\nduration = \"1 s\"\ntools = [\"plate\"]\n");
  const RunOutcome outcome = run(scene);
  EXPECT_FALSE(outcome.facts.completed);
  EXPECT_NE(outcome.facts.reason.find("s: glass has entered tool plate through"), std::string::npos)
      << outcome.facts.reason;
  EXPECT_NE(outcome.facts.reason.find("(what stopped it: glass is inside the tool by"), std::string::npos)
      << outcome.facts.reason;
}

}  // namespace
}  // namespace parison::forming
