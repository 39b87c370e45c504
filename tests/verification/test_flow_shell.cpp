// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "stepping.hpp"

namespace parison::forming {
namespace {

constexpr double inner_radius = 0.01, outer_radius = 0.015, viscosity = 1e4, pressure = 1e5;  // of cases/shell_inflation

/// Time at which the inner radius has doubled: dp = 4 eta a^2 a' (1/a^3 - 1/b^3) + 2 gamma (1/a + 1/b), b^3 - a^3 constant.
double doubling_time(double tension) {
  const double shell = std::pow(outer_radius, 3) - std::pow(inner_radius, 3);
  const auto per_radius = [&](double a) {
    const double b = std::cbrt(a * a * a + shell);
    return 4 * viscosity * a * a * (1 / (a * a * a) - 1 / (b * b * b)) / (pressure - 2 * tension * (1 / a + 1 / b));
  };
  constexpr int intervals = 1000;
  const double h = inner_radius / intervals;
  double time = 0;
  for (int i = 0; i < intervals; ++i) {
    const double a = inner_radius + i * h;
    time += h / 6 * (per_radius(a) + 4 * per_radius(a + 0.5 * h) + per_radius(a + h));
  }
  return time;
}

TEST(ShellInflation, doubles_its_inner_radius_in_the_exact_time_with_and_without_surface_tension) {
  EXPECT_NEAR(doubling_time(0), 0.127525, 5e-7);
  for (const double tension : {0.0, 0.3, 100.0}) {
    Scene scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/shell_inflation", "standard");
    scene.glass.flow->surface_tension = tension;
    const double time = doubling_time(tension);
    scene.stages[0].duration = time;
    const State state = steps_to(scene, initial_state(scene), time);
    const auto& mesh = state.bodies[0].mesh;
    const Index inner = core::find_piece(mesh, "inner");
    double worst = 0;
    for (const auto& edge : mesh.boundary)
      if (edge.piece == inner)
        for (const Index node : edge.nodes)
          worst = std::max(worst, std::abs(mesh.nodes[node].norm() / (2 * inner_radius) - 1));
    const double drift = core::volume(mesh, scene.geometry) / state.first_volume - 1;
    std::printf("shell, tension %5.1f N/m: inner radius doubled off by %.2e, volume by %.2e (largest %.2e), %d steps\n", tension,
                worst, drift, state.totals.largest_drift, state.totals.steps);
    EXPECT_LT(worst, 5e-4);
    EXPECT_LT(std::abs(drift), 1e-5);
  }
}

}  // namespace
}  // namespace parison::forming
