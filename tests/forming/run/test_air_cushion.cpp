// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "../scene_text.hpp"
#include "forming/run/run.hpp"

namespace parison::forming {
namespace {

/// A plug of glass, 10 mm of radius and 20 mm high, 10 mm above the bottom of a closed cup of its own width.
std::string cushion(const std::string& friction) {
  return R"(case = "air_cushion"
geometry = "axisymmetric"
stage = [{ name = "s", duration = "5 s", tools = ["cup"], gravity = "-9.81 m/s2", trapped_air = { law = "isothermal", temperature = "500 degC" } }]
output.interval = "5 s"
[material.m]
density = "2500 kg/m3"
viscosity = { law = "constant", value = "1e4 Pa.s" }
[glass]
material = "m"
boundary = [{ name = "bottom", path = "(0, 0) (10, 0) mm", condition = "contact" },
 { name = "side", path = "(10, 20) mm", condition = "contact" },
 { name = "top", path = "(0, 20) mm", condition = "contact" },
 { name = "axis", path = "(0, 0) mm", condition = "symmetry" }]
[[tool]]
name = "cup"
friction = )" +
         friction + R"(
boundary = [{ name = "in", path = ["(10, 40) (10, -10) mm", "(0, -10) mm"], condition = "contact" },
 { name = "axis", path = "(0, -15) mm", condition = "symmetry" },
 { name = "rest", path = ["(15, -15) mm","(15, 40) mm","(10, 40) mm"], condition = "insulated" }]
)";
}

/// p V = const carries the weight of 490.5 Pa over 10 mm of air after 0.048 mm.
TEST(AirCushion, a_plug_comes_to_rest_on_the_air_below_it) {
  for (const std::string friction : {"\"slip\"", "{ law = \"navier\", coefficient = \"1e6 Pa.s/m\" }"}) {
    const auto outcome = run(scene_of(cushion(friction)));
    EXPECT_TRUE(outcome.facts.completed) << friction << ": " << outcome.facts.reason;
    const CavityAir& air = outcome.state.cavity_air;
    ASSERT_EQ(air.volume.size(), 1u) << friction;
    EXPECT_NEAR(air.energy[0] / air.volume[0] - 101325, 490.5, 3) << friction;
    double lowest = 1;
    for (const Point& x : outcome.state.glass.mesh.nodes) lowest = std::min(lowest, x[1]);
    EXPECT_LT(lowest, -0.048e-3) << friction;
    if (friction != "\"slip\"") EXPECT_GT(lowest, -0.06e-3);
  }
}

}  // namespace
}  // namespace parison::forming
