// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "forming/initial_state.hpp"
#include "verification/advance.hpp"

namespace parison::forming {
namespace {

Scene bundled(const std::string& name) { return read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/" + name, "draft"); }

/// t = 4 eta/(3 dp) ln[(a^3/b^3)/(a0^3/b0^3)] solved for a by bisection.
double shell_radius(double time) {
  const double a0 = 0.01, b0 = 0.015, shell = b0 * b0 * b0 - a0 * a0 * a0;
  double low = a0, high = 0.03;
  for (int i = 0; i < 100; ++i) {
    const double a = 0.5 * (low + high), cube = a * a * a;
    const double t = 4 * 1e4 / (3 * 1e5) * std::log(cube / (cube + shell) * (b0 * b0 * b0) / (a0 * a0 * a0));
    (t < time ? low : high) = a;
  }
  return low;
}

TEST(ShellInflation, reaches_the_exact_inner_radius) {
  const Scene scene = bundled("shell_inflation");
  Workspace workspace;
  const double time = 0.1275;
  const State state = advance_to(scene, initial_state(scene), time, workspace);
  const auto& mesh = state.bodies[0].mesh;
  const Index inner = core::find_piece(mesh, "inner");
  double worst = 0;
  for (const auto& edge : mesh.boundary)
    if (edge.piece == inner)
      for (const Index node : edge.nodes)
        worst = std::max(worst, std::abs(mesh.nodes[node].norm() / shell_radius(time) - 1));
  const double drift = core::volume(mesh, scene.geometry) / state.first_volume - 1;
  std::printf("shell: inner radius off by %.2e, volume by %.2e, %d steps\n", worst, drift, state.totals.steps);
  EXPECT_LT(worst, 3e-3);
  EXPECT_LT(std::abs(drift), 1e-3);
}

TEST(ShellInflation, is_of_second_order_in_time) {
  double last = 0;
  for (const double strain : {0.16, 0.08, 0.04}) {
    Scene scene = bundled("shell_inflation");
    scene.accuracy.strain_per_step = strain;
    scene.accuracy.largest_step = strain / 20;
    scene.accuracy.first_step = strain / 200;
    scene.output.interval = 1;
    Workspace workspace;
    const State state = advance_to(scene, initial_state(scene), 0.12, workspace);
    const auto& mesh = state.bodies[0].mesh;
    const Index inner = core::find_piece(mesh, "inner");
    double error = 0;
    for (const auto& edge : mesh.boundary)
      if (edge.piece == inner) error = std::abs(mesh.nodes[edge.nodes[0]].norm() / shell_radius(0.12) - 1);
    std::printf("shell, strain %.2f a step: %d steps, error %.2e\n", strain, state.totals.steps, error);
    if (last > 0) EXPECT_GT(std::log2(last / error), 1.6);
    last = error;
  }
}

}  // namespace
}  // namespace parison::forming
