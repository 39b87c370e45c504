// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <variant>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "figure.hpp"
#include "forming/run/run.hpp"

namespace parison::forming {
namespace {

void scale(core::Profile& profile, double by) {
  for (core::Segment& segment : profile.segments) {
    for (Point* x : {&segment.start, &segment.end, &segment.centre}) *x *= by;
    segment.radius *= by;
  }
}

void scale(thermal::SurfaceExchange& exchange, double by) {
  exchange.h = exchange.h(0) * by;
}

void scale(std::optional<thermal::Material>& material, double by) {
  for (double& k : material->conductivity.y) k *= by * by;
}

/// The scene with all lengths `by` times as long. Times, temperatures, viscosities and stresses stay, so forces go with
/// the square of the length, conductivities too, conductances and surface tension with the length, gravity and
/// friction with its inverse.
Scene scaled(Scene scene, double by) {
  scale(scene.glass.profile, by);
  scale(scene.glass.thermal, by);
  scene.glass.flow->surface_tension *= by;
  scene.glass.film.min_thickness *= by;
  for (Tool& tool : scene.tools) {
    scale(tool.profile, by);
    scale(tool.thermal, by);
    tool.position *= by;
    tool.friction.coefficient /= by;
  }
  for (Interface& interface : scene.interfaces) {
    std::get<contact::ConstantConductance>(interface.law).h *= by;
    interface.transition_gap *= by;
  }
  for (Stage& stage : scene.stages) {
    stage.gravity /= by;
    scale(stage.air, by);
    for (StageTool& tool : stage.tools)
      if (auto* driven = std::get_if<ForceMotion>(&tool.motion))
        driven->force = driven->force(0) * by * by, driven->speed_limit = driven->speed_limit(0) * by;
  }
  for (double Accuracy::*length :
       {&Accuracy::surface_size, &Accuracy::skin_size, &Accuracy::tool_contact_size, &Accuracy::motion_tolerance})
    scene.accuracy.*length *= by;
  return scene;
}

/// The pot without radiation, which no scaling of constants keeps, at a constant conductance.
Scene pressed() {
  Scene scene = scene_of(pot);
  scene.glass.emissivity = 0;
  scene.glass.thermal->radiation.reset();
  scene.stages.push_back(scene.stages[0]);  // which begins with a new mesh
  scene.stages[0].duration = scene.stages[1].duration =
      0.04;  // a new mesh of the full pot, with points on circles, is one of round-off
  for (Interface& interface : scene.interfaces) interface.law = contact::ConstantConductance{2000};
  return scene;
}

/// Largest difference of two ends of a run: positions over the size of the glass, temperatures over their range.
double difference(const State& state, const State& other, double by) {
  if (state.glass.mesh.nodes.size() != other.glass.mesh.nodes.size()) return 1;
  double worst = 0;
  for (std::size_t n = 0; n < state.glass.mesh.nodes.size(); ++n)
    worst = std::max(worst, (other.glass.mesh.nodes[n] / by - state.glass.mesh.nodes[n]).norm() / 0.02);
  return std::max(worst, (other.glass.temperature - state.glass.temperature).lpNorm<Eigen::Infinity>() / 600);
}

/// What round-off makes of a run: its largest difference from runs with a start warmer by some 1e-12.
double difference_by_round_off(const Scene& scene, const State& end) {
  double worst = 0;
  for (const double warmer : {1e-13, 4e-13, 1e-12, 4e-12}) {
    Scene other = scene;
    other.glass.initial_temperature *= 1 + warmer;
    worst = std::max(worst, difference(end, run(other, {}).state, 1));
  }
  return worst;
}

TEST(Scaling, a_scene_of_any_size_gives_the_same_dimensionless_result) {
  const Scene scene = pressed();
  const RunOutcome original = run(scene, {});
  ASSERT_TRUE(original.facts.completed) << original.facts.reason;
  ASSERT_GE(remeshes(original.state), 1);
  const double round_off = difference_by_round_off(scene, original.state);
  EXPECT_LT(round_off, 1e-5);
  tests::Figure off(
      "pressing a gob: all lengths times 1e-3, 1/1024, 128, 100 or a tenth more or less against the original, over "
      "what round-off makes");
  for (const double size : {1e-3, 1.0 / 1024, 128.0, 100.0})
    for (const double by : {size, 0.9 * size, 1.1 * size}) {
      const RunOutcome copy = run(scaled(scene, by), {});
      ASSERT_TRUE(copy.facts.completed) << by << ": " << copy.facts.reason;
      EXPECT_EQ(copy.state.totals.steps, original.state.totals.steps) << by;
      off.add(difference(original.state, copy.state, by) / round_off);
    }
  off.at_most(3);
}

}  // namespace
}  // namespace parison::forming
