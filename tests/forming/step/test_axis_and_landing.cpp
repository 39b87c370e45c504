// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "../scene_text.hpp"
#include "forming/run/run.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/step.hpp"

namespace parison::forming {
namespace {

/// A gob, on whose lower pole a slender plunger with a round tip presses; slip, so that little holds the axis.
const std::string slender_plunger = R"(case = "slender"
geometry = "axisymmetric"
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
[material.iron]
density = "7200 kg/m3"
[glass]
material = "liquid"
boundary = [
  { name = "surface", condition = "contact", path = ["arc centre (0, 21) mm radius 11 mm from -90 deg to 0 deg", "(11, 60) mm",
    "arc centre (2, 60) mm radius 9 mm from 0 deg to 90 deg", "(0, 69) mm"] },
  { name = "axis", condition = "symmetry", path = "(0, 10) mm" },
]
[[tool]]
name = "tube"
material = "iron"
friction = { law = "navier", coefficient = "1e6 Pa.s/m" }
boundary = [
  { name = "inner", condition = "contact", path = "(11, 0) (11, 100) mm" },
  { name = "rest", condition = "insulated", path = "(30, 100) (30, 0) (11, 0) mm" },
]
[[tool]]
name = "plunger"
material = "iron"
friction = "slip"
position = "10 mm"
boundary = [
  { name = "outer", condition = "contact", path = ["(5, -60) (3, -3) mm", "arc centre (0, -3) mm radius 3 mm from 0 deg to 90 deg"] },
  { name = "axis", condition = "symmetry", path = "(0, -60) mm" },
  { name = "bottom", condition = "insulated", path = "(5, -60) mm" },
]
[[stage]]
name = "press"
duration = "0.15 s"
tools = ["tube", "plunger"]
motion.plunger = { offset = [["0 s", "10 mm"], ["0.15 s", "30 mm"]] }
)";

/// Largest distance of the nodes of symmetry boundaries from the axis, and of all nodes beyond it, m.
double off_axis(const core::Mesh& mesh) {
  double worst = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) == BoundaryKind::symmetry)
      for (const Index node : edge.nodes) worst = std::max(worst, std::abs(mesh.nodes[node][0]));
  for (const Point& x : mesh.nodes) worst = std::max(worst, -x[0]);
  return worst;
}

/// The longest front of contact of all steps that were taken, m.
class Fronts : public RunObserver {
 public:
  double longest = 0;
  void step_taken(const RunView&, const State&, const StepReport& report) override {
    longest = std::max(longest, report.landed_length);
  }
};

TEST(Axis, nodes_on_it_stay_there_to_the_bit_before_a_slender_plunger) {
  const Scene scene = scene_of(slender_plunger, "draft");
  const RunOutcome outcome = run(scene);
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  const core::Mesh& mesh = outcome.state.glass.mesh;
  EXPECT_EQ(off_axis(mesh), 0);
  double pole = 1;  // lowest node of the axis, m
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) == BoundaryKind::symmetry)
      for (const Index node : edge.nodes) pole = std::min(pole, mesh.nodes[node][1]);
  EXPECT_NEAR(pole, 30e-3, 5e-6) << "on the plunger's tip";
  EXPECT_LT(outcome.facts.diagnostics.in_tools.node.depth, 5e-6);
}

/// A plate that nothing loads on a base that rises from rest.
const std::string carried_plate = R"(case = "carried"
geometry = "planar"
material.liquid = { density = "2400 kg/m3", viscosity = { law = "constant", value = "1e5 Pa.s" } }
[[stage]]
name = "rise"
duration = "5 ms"
tools = ["base"]
motion.base = { offset = [["0 s", "0 mm"], ["5 ms", "5 mm"]] }
[glass]
material = "liquid"
boundary = [
  { name = "surface", condition = "contact", path = "(0, 0) (11, 0) (11, 20) (0, 20) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" },
]
[[tool]]
name = "base"
friction = "slip"
boundary = [
  { name = "top", condition = "contact", path = "(33, 0) (0, 0) mm" },
  { name = "rest", condition = "insulated", path = "(0, -6) (33, -6) (33, 0) mm" },
]
)";

TEST(Carried, glass_goes_with_the_base_that_starts_to_rise_below_it) {
  for (const char* accuracy : {"draft", "standard", "fine"}) {
    const Scene scene = scene_of(carried_plate, accuracy);
    const State start = initial_state(scene);
    Workspace workspace;
    const StepResult step = coupled_step(scene, start, 1e-3, workspace);
    ASSERT_TRUE(step.converged) << step.reason;
    double lowest = 1;
    for (const core::Point& x : step.state.glass.mesh.nodes) lowest = std::min(lowest, x[1]);
    EXPECT_NEAR(lowest, 1e-3, 1e-9) << accuracy;
  }
}

/// A capped tube with a fixed rim, blown into a mould.
const std::string blown_tube = R"(case = "blown_tube"
geometry = "axisymmetric"
stage = [ { name = "blow", duration = "0.2 s", tools = ["mould"], pressure.inner = "1 bar" } ]
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e4 Pa.s" }
[material.iron]
density = "7200 kg/m3"
[glass]
material = "liquid"
boundary = [
  { name = "outer", condition = "contact", path = ["arc centre (0, 0) mm radius 14 mm from -90 deg to 0 deg", "(14, 50) mm"] },
  { name = "rim", condition = "fixed", path = "(11, 50) mm" },
  { name = "inner", condition = "air", path = ["(11, 0) mm", "arc centre (0, 0) mm radius 11 mm from 0 deg to -90 deg"] },
  { name = "axis", condition = "symmetry", path = "(0, -14) mm" },
]
[[tool]]
name = "mould"
material = "iron"
friction = "grip"
boundary = [
  { name = "inner", condition = "contact", path = ["(0, -30) (18, -30) mm", "arc centre (18, -22) mm radius 8 mm from -90 deg to 0 deg", "(26, 38) (14.5, 50) mm"] },
  { name = "top", condition = "insulated", path = "(40, 50) mm" },
  { name = "outer", condition = "insulated", path = "(40, -45) (0, -45) mm" },
  { name = "axis", condition = "symmetry", path = "(0, -30) mm" },
]
)";

TEST(Landing, of_a_blown_tube_goes_on_by_less_than_three_edges_in_a_step) {
  const auto longest = [](const std::string& numerics) {
    const Scene scene =
        scene_of(replaced("(26, 38) (14.5, 50) mm", "(26, 47) (14.5, 50) mm", blown_tube) + numerics, "draft");
    Fronts fronts;
    const RunOutcome outcome = run(scene, {&fronts});
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    return fronts.longest / scene.accuracy.surface_size;
  };
  const double controlled = longest(""), free = longest("[numerics]\nlanding_per_step = 1000\n");
  std::printf("longest front in a step: %.2f edges, %.2f without control\n", controlled, free);
  EXPECT_LE(controlled, 3 * 0.7);  // a step with three times what it may have is rejected
  EXPECT_GT(free, 2 * controlled);
}

/// A disc that is held at its top lands on a table that rises, a cone so flat that it meets nearly all of it at once.
const std::string landing_disc = R"(case = "landing"
geometry = "axisymmetric"
[[stage]]
name = "land"
duration = "0.1 s"
tools = ["table"]
motion.table = { offset = [["0 s", "-0.1 mm"], ["0.1 s", "0.1 mm"]] }
[numerics]
landing_per_step = 1000
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e4 Pa.s" }
[material.iron]
density = "7200 kg/m3"
[[tool]]
name = "table"
material = "iron"
friction = "slip"
position = "-0.1 mm"
boundary = [{ name = "face", condition = "contact", path = "(40, 0.04) (0, 0) mm" },
            { name = "axis", condition = "symmetry", path = "(0, -20) mm" },
            { name = "rest", condition = "insulated", path = "(40, -20) mm" }]
[glass]
material = "liquid"
boundary = [BOUNDARIES]
)";

TEST(Landing, across_the_start_of_the_outline_is_one_front) {
  const auto longest = [](const std::string& boundaries) {
    Fronts fronts;
    const RunOutcome outcome = run(scene_of(replaced("BOUNDARIES", boundaries, landing_disc), "draft"), {&fronts});
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    return fronts.longest;
  };
  const std::string
      inner = "{ name = \"inner\", condition = \"contact\", path = \"",
      end = " mm\" }",
      others =
          "{ name = \"side\", condition = \"air\", path = \"(10, 4) mm\" }, { name = \"top\", condition = "
          "\"fixed\", path = \"(0, 4) mm\" }, { name = \"axis\", condition = \"symmetry\", path = "
          "\"(0, 0) mm\" }",
      outer = "{ name = \"outer\", condition = \"contact\", path = \"";
  const double from_axis = longest(inner + "(0, 0) (5, 0)" + end + ", " + outer + "(10, 0)" + end + ", " + others);
  const double from_middle = longest(outer + "(5, 0) (10, 0)" + end + ", " + others + ", " + inner + "(5, 0)" + end);
  std::printf("longest front: %.3f mm, %.3f mm where the outline starts in it\n", 1e3 * from_axis, 1e3 * from_middle);
  EXPECT_GT(from_axis, 5e-3);
  EXPECT_NEAR(from_middle / from_axis, 1, 0.05);
}

/// A capped tube that hangs or stands in a ring that is drawn on its side.
const std::string held_tube = R"(case = "held_tube"
geometry = "axisymmetric"
stage = [ { name = "hold", duration = "0.05 s", tools = ["ring"], gravity = "GRAVITY m/s2" } ]
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e4 Pa.s" }
[material.iron]
density = "7200 kg/m3"
[glass]
material = "liquid"
boundary = [
  { name = "outer", condition = "contact", path = ["arc centre (0, 0) mm radius 14 mm from -90 deg to 0 deg", "(14, 50) mm"] },
  { name = "inner", condition = "contact", path = ["(11, 50) (11, 0) mm", "arc centre (0, 0) mm radius 11 mm from 0 deg to -90 deg"] },
  { name = "axis", condition = "symmetry", path = "(0, -14) mm" },
]
[[tool]]
name = "ring"
material = "iron"
friction = "grip"
boundary = [
  { name = "inner", condition = "contact", path = "(14, 35) (14, 50) mm" },
  { name = "rest", condition = "insulated", path = "(30, 50) (30, 35) (14, 35) mm" },
]
)";

TEST(Grip, holds_the_glass_drawn_on_it_whichever_way_gravity_pulls) {
  for (const char* gravity : {"-9.81", "9.81"}) {
    std::string text = held_tube;
    text.replace(text.find("GRAVITY"), 7, gravity);
    const Scene scene = scene_of(text, "draft");
    const RunOutcome outcome = run(scene, {});
    EXPECT_TRUE(outcome.facts.completed) << gravity << ": " << outcome.facts.reason;
    EXPECT_EQ(outcome.facts.stages.back().end_reason, "duration") << gravity;
  }
}

/// A ball of 10 mm radius in a taper that widens by 4 mm in radius over 46 mm of height, 5 degrees from the axis, which
/// it touches with its centre at 23.43 mm.
std::string ball_in_taper(double centre) {
  return fmt::format(R"(case = "taper"
geometry = "axisymmetric"
[numerics]
surface_size = "2 mm"
[material.soft]
density = "2400 kg/m3"
viscosity = {{ law = "constant", value = "1e3 Pa.s" }}
[glass]
material = "soft"
boundary = [
  {{ name = "surface", path = "arc centre (0, {0}) mm radius 10 mm from -90 deg to 90 deg", condition = "contact" }},
  {{ name = "axis", path = "(0, {1}) mm", condition = "symmetry" }} ]
[[tool]]
name = "mould"
friction = {{ law = "navier", coefficient = "1e6 Pa.s/m" }}
boundary = [
  {{ name = "inner", path = "(8, 0) (12, 46) mm", condition = "contact" }},
  {{ name = "outer", path = "(20, 46) (20, 0) (8, 0) mm", condition = "insulated" }} ]
[[stage]]
name = "settle"
duration = "20 ms"
gravity = "-9.81 m/s2"
tools = ["mould"]
)",
                     centre, centre - 10);
}

TEST(Landing, a_gob_that_stands_above_a_steep_taper_falls_onto_it) {
  for (const double above : {0.002, 0.3}) {
    const RunOutcome outcome = run(scene_of(ball_in_taper(23.43 + above)));
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    const auto& tools = outcome.state.glass.contact_tool;
    EXPECT_GT(std::count(tools.begin(), tools.end(), 0), 0) << above;
    EXPECT_LT(outcome.facts.diagnostics.in_tools.node.depth, 5e-6) << above;
  }
}

}  // namespace
}  // namespace parison::forming
