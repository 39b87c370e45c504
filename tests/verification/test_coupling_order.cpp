// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "figure.hpp"
#include "forming/scene_text.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/step.hpp"

namespace parison::forming {
namespace {

/// A hot disc pressed between cold plates that it wets from the start: viscosity, contact pressure and conductance all
/// change by much on the way.
const std::string pressed_disc = R"(case = "pressed_disc"
geometry = "axisymmetric"
air = { temperature = "50 degC", h = "20 W/m2/K", ambient = "50 degC" }
)" + container_glass("20 W/m/K") +
                                 iron + pressed_contact(R"("plate", "plunger")") +
                                 disc_between_plates(8, R"(material = "glass"
temperature = "1000 degC"
mesh = { mapped = [6, 6] }
)",
                                                     R"(material = "iron"
temperature = "500 degC"
friction = { law = "navier", coefficient = "1e5 Pa.s/m" }
)") + R"([[stage]]
name = "press"
duration = "0.32 s"
tools = ["plate", "plunger"]
motion.plunger = { offset = [["0 s", "0 mm"], ["0.32 s", "-2.4 mm"]] }
)";

struct End {
  double mean, radius, force;
};

/// State after `steps` equal steps.
End after_equal_steps(Scene& scene, int steps) {
  scene.accuracy.temperature_tolerance = 1e-5;
  scene.accuracy.motion_tolerance = 1;  // nothing is repeated
  scene.accuracy.temperature_per_step = 1e3;
  State state = initial_state(scene);
  Workspace workspace;
  const double dt = scene.stages[0].duration / steps;
  double last_force = 0;
  for (int i = 0; i < steps; ++i) {
    auto result = coupled_step(scene, state, dt, workspace);
    EXPECT_TRUE(result.converged) << result.reason;
    last_force = state.tools[1].force;
    state = std::move(result.state);
  }
  double radius = 0;
  for (const auto& x : state.glass.mesh.nodes) radius = std::max(radius, x[0]);
  // Forces are of the steps' middles.
  return {state.glass.temperature.mean(), radius, 1.5 * state.tools[1].force - 0.5 * last_force};
}

TEST(Coupling, of_flow_and_heat_is_of_second_order_in_one_coupling_iteration) {
  Scene scene = scene_of(pressed_disc, "standard");
  constexpr int levels = 6;
  std::array<End, levels> end;
  for (int i = 0; i < levels; ++i) {
    end[i] = after_equal_steps(scene, 16 << i);
    std::printf("%3d steps: mean %.5f K, radius %.7f mm, force %.4f N\n", 16 << i, end[i].mean, 1e3 * end[i].radius,
                end[i].force);
  }
  const auto difference = [&](double End::*quantity, int i) {
    return std::abs(end[i].*quantity - end[i + 1].*quantity);
  };
  const auto order = [&](double End::*quantity, int i) {
    return std::log2(difference(quantity, i) / difference(quantity, i + 1));
  };
  for (int i = 0; i + 2 < levels; ++i)
    std::printf("orders: mean temperature %.2f, radius %.2f, force %.2f\n", order(&End::mean, i),
                order(&End::radius, i), order(&End::force, i));
  // The finest order of which both differences are above what the iterations of a step leave.
  const auto finest_order = [&](double End::*quantity) {
    constexpr double resolved = 2e-8;
    int i = levels - 3;
    while (i > 0 && difference(quantity, i + 1) < resolved * std::abs(end[i].*quantity)) --i;
    return order(quantity, i);
  };
  const auto expect_second = [&](const char* what, double End::*quantity) {
    tests::expect_at_least(fmt::format("order in time of the coupling of flow and heat, one pass: {}", what),
                           finest_order(quantity), 1.9);
  };
  expect_second("mean temperature", &End::mean);
  expect_second("radius", &End::radius);
  expect_second("force", &End::force);
  RecordProperty("mean_temperature", std::to_string(finest_order(&End::mean)));
  RecordProperty("radius", std::to_string(finest_order(&End::radius)));
  RecordProperty("force", std::to_string(finest_order(&End::force)));
}

}  // namespace
}  // namespace parison::forming
