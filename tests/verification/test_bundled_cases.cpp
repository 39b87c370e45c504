// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "forming/initial_state.hpp"
#include "forming/step.hpp"
#include "forming/step_control.hpp"

namespace parison::forming {
namespace {

constexpr double celsius = 273.15;

Scene bundled(const std::string& name) { return read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/" + name, "draft"); }

/// Steps as `run` does, without its files, to a time of the first stage.
State advance_to(const Scene& scene, State state, double time, Workspace& workspace) {
  if (state.next_step == 0) state.next_step = scene.accuracy.first_step;
  while (state.time < time - 1e-12) {
    const double dt = std::min(landing_step(scene, state, state.next_step), time - state.time);
    auto result = coupled_step(scene, state, dt, workspace);
    EXPECT_TRUE(result.converged) << result.reason;
    if (!result.converged) break;
    result.state.next_step = wished_step(scene, result.report, state.next_step);
    state = std::move(result.state);
  }
  return state;
}

struct Range {
  double lowest = 1e9, highest = -1e9;
};

Range contact_temperature(const BodyState& body) {
  Range range;
  const Index piece = core::find_piece(body.mesh, "contact");
  for (const auto& edge : body.mesh.boundary)
    if (edge.piece == piece)
      for (const Index node : edge.nodes) {
        range.lowest = std::min(range.lowest, body.temperature[node] - celsius);
        range.highest = std::max(range.highest, body.temperature[node] - celsius);
      }
  return range;
}

/// verification.md, section 1: time, glass side, steel side, heat per area.
constexpr std::array<std::array<double, 4>, 4> exact{{{1, 742.0877, 575.8608, 1236161},
                                                      {2, 706.4829, 583.7917, 1941847},
                                                      {5, 671.5318, 591.5769, 3393853},
                                                      {10, 652.8883, 595.7298, 5060352}}};

TEST(ContactCylinders, follow_the_exact_solution_on_all_mesh_pairs) {
  for (const auto& [glass, steel] : {std::pair{20, 20}, {20, 7}, {7, 20}, {20, 13}, {13, 20}}) {
    Scene scene = bundled("contact_cylinders");
    scene.glass.mesh.mapped->along_first = glass;
    scene.tools[0].mesh.mapped->along_first = steel;
    State state = initial_state(scene);
    Workspace workspace;
    double worst = 0, spread = 0;
    for (const auto& [time, glass_side, steel_side, heat] : exact) {
      state = advance_to(scene, state, time, workspace);
      const Range hot = contact_temperature(state.bodies[0]), cold = contact_temperature(state.bodies[1]);
      worst = std::max({worst, std::abs(hot.lowest - glass_side), std::abs(hot.highest - glass_side),
                        std::abs(cold.lowest - steel_side), std::abs(cold.highest - steel_side)});
      spread = std::max({hot.highest - hot.lowest, cold.highest - cold.lowest});
      const double area = M_PI * 0.02 * 0.02;
      EXPECT_NEAR(state.totals.to_tools, heat * area, 2e-4 * heat * area);
      EXPECT_NEAR(state.bodies[1].heat_received, state.totals.to_tools, 1e-10 * state.totals.to_tools);
    }
    std::printf("glass/steel %2d/%2d: worst deviation %.4f K, spread at 10 s %.2e K\n", glass, steel, worst, spread);
    EXPECT_LT(worst, 0.5);
    EXPECT_LT(spread, 0.02);
  }
}

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
