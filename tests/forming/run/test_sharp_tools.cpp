// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../scene_text.hpp"
#include "forming/run/run.hpp"

namespace parison::forming {
namespace {

/// A pressed lens, 100 mm wide, with five sharp teeth of 2 mm in a mould whose bottom is a hollow cone at the axis.
const std::string lens = R"(
case = "fresnel"
geometry = "axisymmetric"
stage = [
  { name = "settle", duration = "0.2 s", gravity = "-9.81 m/s2", tools = ["mould", "ring", "plunger"] },
  { name = "press", duration = "2 s", gravity = "-9.81 m/s2", tools = ["mould", "ring", "plunger"], motion.plunger = { force = "-25 kN", speed_limit = "100 mm/s" }, end_speed = "1 mm/s" },
  { name = "dwell", duration = "0.2 s", gravity = "-9.81 m/s2", tools = ["mould", "ring", "plunger"], motion.plunger = { force = "-1 kN", speed_limit = "100 mm/s" } },
]
air = { temperature = "40 degC", h = "20 W/m2/K", ambient = "40 degC" }
output.interval = "10 s"
[[interface]]
tools = ["mould", "ring", "plunger"]
law = "pressure-viscosity"
h0 = "500 W/m2/K"
h1 = "20000 W/m2/K"
p_ref = "0.2 MPa"
eta_ref = "1e3 Pa.s"
a = 1
b = 0.25
[glass]
material = "flint"
temperature = "1100 degC"
gob = { mass = "250 g", diameter = "56 mm", at = "(0, 0.0506) mm" }
[[tool]]
name = "mould"
material = "grey_iron"
temperature = "450 degC"
friction = { law = "navier", coefficient = "5e5 Pa.s/m" }
boundary = [
  { name = "inner", condition = "contact", path = "(0, 0) (10, 0.6) (10, -1.2) (18, 0.6) (18, -1.4) (26, 0.6) (26, -1.6) (34, 0.6) (34, -1.8) (42, 0.6) (50, 1) (51, 14) mm" },
  { name = "top", condition = "insulated", path = "(85, 14) mm" },
  { name = "outer", condition.cooled = { h = "300 W/m2/K", temperature = "40 degC" }, path = "(85, -35) (0, -35) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" },
]
[[tool]]
name = "ring"
material = "grey_iron"
temperature = "430 degC"
friction = { law = "navier", coefficient = "5e5 Pa.s/m" }
boundary = [
  { name = "under", condition = "contact", path = ["(47, 40) (47, 14) (55, 14) mm"] },
  { name = "joint", condition = "insulated", path = "(85, 14) mm" },
  { name = "outer", condition.cooled = { h = "200 W/m2/K", temperature = "40 degC" }, path = "(85, 40) mm" },
  { name = "top", condition = "insulated", path = "(47, 40) mm" },
]
[[tool]]
name = "plunger"
material = "H13"
temperature = "480 degC"
friction = { law = "navier", coefficient = "5e5 Pa.s/m" }
position = "70 mm"
boundary = [
  { name = "face", condition = "contact", path = ["(0, 0) mm", "(30, 1) (47, 3) (47, 40) mm"] },
  { name = "top", condition = "insulated", path = "(10, 40) mm" },
  { name = "bore", condition.cooled = { h = "1000 W/m2/K", temperature = "40 degC" }, path = "(10, 15) (0, 15) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" },
]
)";

TEST(SharpTools, a_lens_with_teeth_is_pressed_in_some_hundred_steps_and_stays_outside_the_teeth) {
  const RunOutcome outcome = run(scene_of(lens, "draft coarser 2"));
  const Totals& totals = outcome.state.totals;
  EXPECT_EQ(outcome.facts.reason, "");
  EXPECT_LT(totals.steps + totals.rejected, 300);
  EXPECT_LT(totals.max_penetration, 10e-6);
}

}  // namespace
}  // namespace parison::forming
