// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "core/mesh/mesh.hpp"
#include "figure.hpp"
#include "forming/run/run.hpp"
#include "forming/scene_text.hpp"

namespace parison::forming {
namespace {

constexpr double radius = 4e-3, length = 160e-3, depth = 1e-3, density = 2500, gravity = 9.81, duration = 2e-3;

double kelvin_at(double r) {
  return 1050 + 273.15 - 200 * std::exp((r - radius) / depth);
}
double viscosity_at(double r) {
  return std::pow(10, -2.309 + 3922 / (kelvin_at(r) - 291 - 273.15));
}

/// A rod with a skin 200 K colder than its core hangs from its middle; no tool is near, and no heat flows to speak of.
const char* const rod = R"toml(case = "rod"
geometry = "axisymmetric"
air = { temperature = "1000 degC", h = "1e-3 W/m2/K", ambient = "1000 degC" }
stage = [{ name = "hang", duration = "2 ms", gravity = "-9.81 m/s2" }]
[material.glass]
density = "2500 kg/m3"
heat_capacity = "1200 J/kg/K"
conductivity = "0.01 W/m/K"
viscosity = { law = "vft", A = -2.309, B = "3922 K", T0 = "291 degC" }
[glass]
material = "glass"
temperature = { formula = "1050 degC - 200 K * exp((r - 4 mm) / 1 mm)" }
boundary = [
  { name = "side", condition = "air", path = "(0, 0) (4, 0) (4, 160) mm" },
  { name = "middle", condition = "symmetry", path = "(0, 160) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" },
]
)toml";

/// Speed of the lower end by F. T. Trouton, Proc. R. Soc. A 77 (1906) 426-440: the load of each cross section over
/// three times the mean viscosity there. The core runs ahead of its skin by 0.3 % of it.
double exact_speed() {
  constexpr int parts = 20000;
  double mean = 0;
  for (int i = 0; i < parts; ++i) {
    const double r = radius * (i + 0.5) / parts;
    mean += viscosity_at(r) * 2 * r / (radius * parts);
  }
  return density * gravity * length * length / (6 * mean);
}

double speed(const std::string& accuracy) {
  const auto outcome = run(scene_of(rod, accuracy));
  EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  double lowest = length;
  for (const core::Point& node : outcome.state.glass.mesh.nodes) lowest = std::min(lowest, node[1]);
  return -lowest / duration;
}

TEST(ChilledRod, stretches_as_its_skin_lets_it_at_each_accuracy) {
  const double exact = exact_speed();
  tests::Figure draft("rod with a skin 200 K colder and 1 mm deep, stretched by its weight, draft: rate off by"),
      finer("the same, standard and fine");
  for (const char* accuracy : {"draft", "standard", "fine"}) {
    const double found = speed(accuracy);
    std::printf("%s: %.4f mm/s, exact %.4f, off by %.2e\n", accuracy, 1e3 * found, 1e3 * exact, found / exact - 1);
    (accuracy == std::string("draft") ? draft : finer).add(std::abs(found / exact - 1));
  }
  draft.at_most(1.5e-2);
  finer.at_most(5e-3);
}

}  // namespace
}  // namespace parison::forming
