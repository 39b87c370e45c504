// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "figure.hpp"
#include "stepping.hpp"

namespace parison::forming {
namespace {

constexpr double inner_radius = 0.01, outer_radius = 0.015, viscosity = 1e4,
                 pressure = 1e5;  // of cases/shell_inflation

/// Time at which the inner radius has doubled: dp = 4 eta a^2 a' (1/a^3 - 1/b^3) + 2 gamma (1/a + 1/b), b^3 - a^3
/// constant.
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

/// The inner radius at a time without surface tension, by bisection of t = 4 eta/(3 dp) ln[(a^3/b^3)/(a0^3/b0^3)].
double radius_at(double time) {
  const double shell = std::pow(outer_radius, 3) - std::pow(inner_radius, 3);
  const auto log_ratio = [&](double a) { return std::log(a * a * a / (a * a * a + shell)); };
  double low = inner_radius, high = 3 * inner_radius;
  for (int i = 0; i < 100; ++i) {
    const double a = 0.5 * (low + high);
    const double t = 4 * viscosity / (3 * pressure) * (log_ratio(a) - log_ratio(inner_radius));
    (t < time ? low : high) = a;
  }
  return low;
}

Scene shell() {
  return read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/shell_inflation", "standard",
                    {"numerics.strain_per_step=0.04"});
}

/// How far the inner surface is off a radius at its worst node, relative to it.
double radius_error(const core::Mesh& mesh, double radius) {
  const Index inner = core::find_boundary(mesh, "inner");
  double worst = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (edge.boundary_id == inner)
      for (const Index node : edge.nodes) worst = std::max(worst, std::abs(mesh.nodes[node].norm() / radius - 1));
  return worst;
}

double volume_drift(const Scene& scene, const State& state) {
  return core::volume(state.glass.mesh, scene.geometry) / state.glass.initial_volume - 1;
}

TEST(ShellInflation, doubles_its_inner_radius_in_the_exact_time_with_and_without_surface_tension) {
  EXPECT_NEAR(doubling_time(0), 0.127525, 5e-7);
  tests::Figure radius(
      "spherical shell to twice its radius, with and without surface tension, standard: radius off by"),
      volume("the same: volume off by");
  for (const double tension : {0.0, 0.3, 100.0}) {
    Scene scene = shell();
    scene.glass.flow->surface_tension = tension;
    const double time = doubling_time(tension);
    scene.stages[0].duration = time;
    const State state = steps_to(scene, initial_state(scene), time);
    const double worst = radius_error(state.glass.mesh, 2 * inner_radius), drift = volume_drift(scene, state);
    std::printf("shell, tension %5.1f N/m: inner radius doubled off by %.2e, volume by %.2e, %d steps\n", tension,
                worst, drift, state.totals.steps);
    radius.add(worst);
    volume.add(std::abs(drift));
  }
  radius.at_most(5e-4);
  volume.at_most(1e-5);
}

TEST(ShellInflation, is_of_second_order_in_time) {
  tests::Figure order("the same shell, steps halved twice: order in time");
  double last = 0;
  for (const double strain : {0.16, 0.08, 0.04}) {
    Scene scene = shell();
    scene.accuracy.strain_per_step = strain;
    scene.accuracy.work_per_step = 1;  // the strain alone sets the step
    scene.accuracy.max_step = strain / 20;
    scene.accuracy.initial_step = strain / 200;
    scene.output.interval = 1;
    const State state = steps_to(scene, initial_state(scene), 0.12);
    const double error = radius_error(state.glass.mesh, radius_at(0.12));
    std::printf("shell, strain %.2f a step: %d steps, error %.2e\n", strain, state.totals.steps, error);
    if (last > 0) order.add(std::log2(last / error));
    last = error;
  }
  order.at_least(1.6);
}

}  // namespace
}  // namespace parison::forming
