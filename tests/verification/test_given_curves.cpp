// SPDX-License-Identifier: GPL-3.0-or-later
// Pressures, forces and speed limits given over the time of a stage, against exact solutions.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "forming/run/run.hpp"
#include "forming/scene/scene.hpp"
#include "stepping.hpp"

namespace parison::forming {
namespace {

using core::Table;
using core::TimeFunction;

/// The cube of the inner radius of cases/shell_inflation over that of the outer one depends on the impulse of the
/// pressure alone: d ln(a^3/b^3)/dt = 3 p/(4 eta).
double radius_after(double impulse) {
  constexpr double inner = 0.01, outer = 0.015, viscosity = 1e4;
  const double shell = std::pow(outer, 3) - std::pow(inner, 3);
  const double ratio = std::pow(inner / outer, 3) * std::exp(3 * impulse / (4 * viscosity));
  return std::cbrt(shell * ratio / (1 - ratio));
}

/// Rises, falls within 10 ms, rises again and stays.
const Table pressure{{0, 0.05, 0.06, 0.09}, {0, 2e5, 0.5e5, 1.5e5}};
constexpr double blown = 0.11, impulse = 12250;  // s, Pa.s

Scene blown_shell() {
  Scene scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/shell_inflation", "standard",
                           {"numerics.strain_per_step=0.04"});
  scene.stages[0].pressure["inner"] = TimeFunction(pressure);
  scene.stages[0].duration = blown;
  return scene;
}

double radius_error(const State& state) {
  const core::Mesh& mesh = state.glass.mesh;
  const Index inner = core::find_boundary(mesh, "inner");
  double worst = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (edge.boundary_id == inner)
      for (const Index node : edge.nodes)
        worst = std::max(worst, std::abs(mesh.nodes[node].norm() / radius_after(impulse) - 1));
  return worst;
}

TEST(GivenCurves, a_shell_under_a_pressure_that_rises_and_falls_has_the_exact_radius) {
  ASSERT_NEAR(Table(pressure).integral(blown), impulse, 1e-9);
  EXPECT_NEAR(radius_after(0), 0.01, 1e-12);
  const Scene scene = blown_shell();
  std::vector<double> times;
  const State state = steps_to(scene, initial_state(scene), blown,
                               [&](const State&, const State& after) { times.push_back(after.time); });
  std::printf("shell under a pressure over time: radius off by %.2e in %d steps\n", radius_error(state),
              state.totals.steps);
  EXPECT_LT(radius_error(state), 5e-4);
  for (const double kink : {0.05, 0.06, 0.09}) {
    double nearest = 1;
    for (const double time : times) nearest = std::min(nearest, std::abs(time - kink));
    EXPECT_LT(nearest, 1e-9) << kink;
  }
}

TEST(GivenCurves, a_pressure_over_time_keeps_the_second_order_in_time) {
  double last = 0;
  for (const double strain : {0.08, 0.04, 0.02}) {
    Scene scene = blown_shell();
    scene.accuracy.strain_per_step = strain;
    scene.accuracy.work_per_step = 1;  // strain and pressure alone set the step
    scene.accuracy.max_step = strain / 20;
    scene.accuracy.initial_step = strain / 200;
    const double error = radius_error(steps_to(scene, initial_state(scene), blown));
    std::printf("shell under a pressure over time, strain %.2f a step: error %.2e\n", strain, error);
    if (last > 0) EXPECT_GT(std::log2(last / error), 1.6);
    last = error;
  }
}

Scene squeezed_disc() {
  Scene scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/tests/bars/scenes/squeeze_slip.toml", "standard");
  scene.stages[0].end_speed.reset();
  scene.stages[0].duration = 0.3;
  return scene;
}

double height(const State& state) {
  return state.tools[1].offset;
}

/// Between slipping plates 1/h grows by the impulse of the force over 3 eta V.
TEST(GivenCurves, a_disc_pressed_by_a_force_over_time_has_the_exact_height) {
  Scene scene = squeezed_disc();
  const Table force{{0, 0.1, 0.101, 0.2}, {0, -400, -50, -300}};
  std::get<ForceMotion>(scene.stages[0].tools[1].motion).force = TimeFunction(force);
  const RunOutcome outcome = run(scene, {});
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  const double volume = M_PI * 1e-6, exact = 1 / (100 - force.integral(0.3) / (3 * 1e4 * volume));
  std::printf("disc under a force over time: height off by %.2e\n", height(outcome.state) / exact - 1);
  EXPECT_LT(exact, 0.0065);
  EXPECT_NEAR(height(outcome.state) / exact, 1, 2e-3);
}

TEST(GivenCurves, a_tool_that_nothing_stops_follows_its_speed_limit_over_time) {
  Scene scene = squeezed_disc();
  const Table limit{{0, 0.1, 0.2}, {5e-3, 20e-3, 10e-3}};
  auto& motion = std::get<ForceMotion>(scene.stages[0].tools[1].motion);
  motion.force = -1e5;
  motion.speed_limit = TimeFunction(limit);
  const RunOutcome outcome = run(scene, {});
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_NEAR(height(outcome.state), 0.01 - limit.integral(0.3), 1e-9);
}

}  // namespace
}  // namespace parison::forming
