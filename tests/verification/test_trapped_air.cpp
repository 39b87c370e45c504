// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "figure.hpp"
#include "forming/scene_text.hpp"
#include "forming/step/work.hpp"
#include "stepping.hpp"

namespace parison::forming {
namespace {

constexpr double ambient = 101325, area = M_PI * 1e-4;

/// A plug of glass, 10 mm radius and from 5 to 15 mm high, in a cup of the same radius, and a tool above it.
std::string plug_in_cup(const std::string& air, const std::string& friction, const std::string& upper_tool,
                        const std::string& stage, const std::string& geometry = "axisymmetric") {
  return fmt::format(R"(case = "plug"
geometry = "{}"
trapped_air = {{ {}, temperature = "500 degC" }}
[material.stiff]
density = "2400 kg/m3"
viscosity = {{ law = "constant", value = "1e7 Pa.s" }}
[glass]
material = "stiff"
mesh = {{ mapped = [6, 6] }}
boundary = [
  {{ name = "bottom", condition = "contact", path = "(0, 5) (10, 5) mm" }},
  {{ name = "side", condition = "contact", path = "(10, 15) mm" }},
  {{ name = "top", condition = "contact", path = "(0, 15) mm" }},
  {{ name = "axis", condition = "symmetry", path = "(0, 5) mm" }} ]
[[tool]]
name = "cup"
friction = {}
boundary = [
  {{ name = "inner", condition = "contact", path = "(10, 40) (10, 0) (0, 0) mm" }},
  {{ name = "axis", condition = "symmetry", path = "(0, -10) mm" }},
  {{ name = "rest", condition = "insulated", path = "(20, -10) (20, 40) (10, 40) mm" }} ]
[[tool]]
name = "{}"
friction = "slip"
boundary = [
  {{ name = "face", condition = "contact", path = "(0, 0) (10, 0) mm" }},
  {{ name = "rest", condition = "insulated", path = "(10, 20) (0, 20) mm" }},
  {{ name = "axis", condition = "symmetry", path = "(0, 0) mm" }} ]
{})",
                     geometry, air, friction, upper_tool, stage);
}

/// The largest error of the force on a plunger that presses the plug down by 2.5 mm.
double force_error(const std::string& law, double exponent, const std::string& geometry) {
  const Scene scene = scene_of(plug_in_cup("law = \"" + law + '"', R"({ law = "navier", coefficient = "1 Pa.s/m" })",
                                           "plunger\"\nposition = \"15 mm", R"([[stage]]
name = "press"
duration = "0.25 s"
tools = ["cup", "plunger"]
motion.plunger = { offset = [["0 s", "15 mm"], ["0.25 s", "12.5 mm"]] }
)",
                                           geometry));
  const double face = geometry == "planar" ? 0.01 : area;
  double worst = 0;
  int steps = 0;
  const State end = steps_to(scene, initial_state(scene), 0.25, [&](const State&, const State& after) {
    const double over = ambient * (std::pow(5e-3 / (after.tools[1].offset - 10e-3), exponent) - 1);
    worst = std::max(worst, std::abs(-after.tools[1].force / (over * face) - 1));
    ++steps;
  });
  EXPECT_EQ(end.cavity_air.volume.size(), 1u);
  std::printf("%s, %s: force off by %.1e at the worst of %d steps, work off by %.1e\n", law.c_str(), geometry.c_str(),
              worst, steps, work_imbalance(end.totals.work));
  return worst;
}

TEST(TrappedAirMotion, a_piston_of_glass_pays_for_the_air_that_it_compresses) {
  tests::Figure force("plug of glass that compresses sealed air to half its volume: force off by");
  for (const char* geometry : {"axisymmetric", "planar"}) {
    force.add(force_error("isothermal", 1, geometry));
    force.add(force_error("adiabatic", 1.4, geometry));
  }
  force.at_most(1e-4);
}

/// Height of the plug over the floor after a time, by the balance of friction and both pressures.
double exact_height(double time) {
  const double resistance = 1e6 * 2 * M_PI * 0.01 * 0.01;
  double h = 5e-3;
  const int steps = 100000;
  const double dt = time / steps;
  for (int i = 0; i < steps; ++i) {
    const auto speed = [&](double height, double t) {
      const double lid = 30e-3 - 5e-3 * std::min(1.0, t / 0.1);
      return ambient * area / resistance * (5e-3 / height - 15e-3 / (lid - 10e-3 - height));
    };
    const double t = i * dt, middle = h + 0.5 * dt * speed(h, t);
    h += dt * speed(middle, t + 0.5 * dt);
  }
  return h;
}

/// Height of the plug at a time, between the floor of the cup and a lid that comes down by 5 mm in 0.1 s.
double plug_height(double step, double time) {
  Scene scene = scene_of(plug_in_cup("law = \"isothermal\"", R"({ law = "navier", coefficient = "1e6 Pa.s/m" })",
                                     "lid\"\nposition = \"30 mm", R"([[stage]]
name = "close"
duration = "5 s"
tools = ["cup", "lid"]
motion.lid = { offset = [["0 s", "30 mm"], ["0.1 s", "25 mm"], ["5 s", "25 mm"]] }
)"));
  scene.accuracy.max_step = step;
  scene.accuracy.initial_step = std::min(step, 1e-3);
  const State end = steps_to(scene, initial_state(scene), time);
  EXPECT_EQ(end.cavity_air.volume.size(), 2u);
  return (end.cavity_air.volume.empty() ? 0.0 : end.cavity_air.volume[0]) / area;
}

TEST(TrappedAirMotion, a_plug_between_two_gases_follows_their_balance) {
  const double exact = exact_height(0.12), coarse = plug_height(8e-3, 0.12) - exact,
               fine = plug_height(4e-3, 0.12) - exact;
  std::printf("plug between two gases: height off by %.3g and %.3g um of %.3g mm\n", 1e6 * coarse, 1e6 * fine,
              1e3 * exact);
  EXPECT_LT(std::abs(fine), 0.02 * 1e-3);
  tests::expect_at_least("plug between two gases: order in the step", std::log2(coarse / fine), 0.8);
}

TEST(TrappedAirMotion, long_steps_lead_a_plug_to_equal_pressures_without_swinging) {
  tests::expect_at_most("plug between two gases, steps longer than its time: rest off equal pressures by",
                        std::abs(plug_height(0.5, 5) / 3.75e-3 - 1), 1e-4);
}

TEST(TrappedAirMotion, a_vent_lets_the_air_out_and_the_plug_down) {
  const auto scene = scene_of(plug_in_cup(R"(law = "adiabatic", vent_area = "5 mm2")",
                                          R"({ law = "navier", coefficient = "1 Pa.s/m" })",
                                          "plunger\"\nposition = \"15 mm", R"([[stage]]
name = "press"
duration = "0.5 s"
tools = ["cup", "plunger"]
motion.plunger = { offset = [["0 s", "15 mm"], ["0.25 s", "12.5 mm"], ["0.5 s", "12.5 mm"]] }
)"));
  const State end = steps_to(scene, initial_state(scene), 0.5);
  ASSERT_EQ(end.cavity_air.volume.size(), 1u);
  EXPECT_NEAR(end.cavity_air.energy[0] / end.cavity_air.volume[0], ambient, 0.001 * ambient);
  EXPECT_NEAR(end.cavity_air.amount[0] / (0.5 * ambient * area * 5e-3), 1, 0.02);
}

}  // namespace
}  // namespace parison::forming
