// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary values of the case file that change with the time of the run.
#include <gtest/gtest.h>

#include <cmath>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "forming/run/run.hpp"

namespace parison::forming {
namespace {

const std::string rest = "path = \"(15, 20) (0, 20) mm\", condition = \"insulated\"";
const std::string rest_with = "path = \"(15, 20) (0, 20) mm\", condition.";

TEST(TimeDependentBoundaries, the_case_file_gives_pairs_of_time_and_value) {
  const Scene cooled = scene_of(replaced(
      rest, rest_with + R"(cooled = { h = [["0 s", "100 W/m2/K"], ["2 s", "300 W/m2/K"]], temperature = "50 degC" })"));
  const auto& cooling = cooled.tools[1].boundaries[1].cooling;
  EXPECT_DOUBLE_EQ(cooling.h(-1), 100);
  EXPECT_DOUBLE_EQ(cooling.h(0.5), 150);
  EXPECT_DOUBLE_EQ(cooling.h(5), 300);
  EXPECT_DOUBLE_EQ(cooling.air_temperature(5), 323.15);
  const Scene given =
      scene_of(replaced(rest, rest_with + R"(temperature = [["1 s", "50 degC"], ["3 s", "1250 degC"]])"));
  EXPECT_DOUBLE_EQ(given.tools[1].boundaries[1].temperature(2), 923.15);
  EXPECT_DOUBLE_EQ(temperature_range(given).max_temperature, 1523.15);
  const Scene air = scene_of(replaced("geometry = \"axisymmetric\"\n", R"(geometry = "axisymmetric"
[air]
temperature = [["0 s", "20 degC"], ["3 s", "80 degC"]]
h = [["0 s", "0 W/m2/K"], ["3 s", "30 W/m2/K"]]
ambient = [["0 s", "20 degC"], ["3 s", "50 degC"]]
)"));
  for (const Stage& stage : air.stages) {
    EXPECT_DOUBLE_EQ(stage.air.air_temperature(1), 313.15);
    EXPECT_DOUBLE_EQ(stage.air.h(1), 10);
    EXPECT_DOUBLE_EQ(stage.air.ambient_temperature(1), 303.15);
  }
}

TEST(TimeDependentBoundaries, a_heat_transfer_coefficient_below_zero_is_refused_at_its_place) {
  const auto text = replaced(rest, rest_with +
                                       "cooled = { temperature = \"50 degC\", h = [[\"0 s\", \"100 W/m2/K\"],\n"
                                       "[\"2 s\", \"-1 W/m2/K\"]] }");
  EXPECT_EQ(complaint_about(text), std::to_string(line_of("-1 W/m2/K", text)) +
                                       ": tool.boundary.condition.cooled.h: \"-1 W/m2/K\" was found, allowed is a "
                                       "heat transfer coefficient such as \"5000 W/m2/K\", not below zero");
}

/// Largest distance of a boundary's nodes from a temperature, K.
double max_difference(const core::Mesh& mesh, const Eigen::VectorXd& temperature, const std::string& boundary,
                      double expected) {
  const Index id = core::find_boundary(mesh, boundary);
  double largest = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (edge.boundary_id == id)
      for (const Index node : edge.nodes) largest = std::max(largest, std::abs(temperature[node] - expected));
  return largest;
}

void prescribe(Body& body, const std::string& name, const core::TimeFunction& temperature) {
  for (Boundary& boundary : body.boundaries)
    if (boundary.name == name) {
      boundary.kind = BoundaryKind::temperature;
      boundary.temperature = temperature;
    }
}

TEST(TimeDependentBoundaries, a_static_stage_takes_them_at_the_time_of_the_run) {
  Scene scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/contact_cylinders", "draft");
  prescribe(scene.glass, "top", core::TimeFunction(core::Table{{0, 2}, {1400, 1200}}));
  scene.stages[0].duration = 0.5;
  scene.stages.push_back(scene.stages[0]);
  const auto outcome = run(scene, {});
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_NEAR(outcome.state.time, 1, 1e-9);
  EXPECT_LT(max_difference(outcome.state.glass.mesh, outcome.state.glass.temperature, "top", 1300), 1e-6);
}

TEST(TimeDependentBoundaries, a_step_with_flow_takes_them_at_the_time_of_the_run) {
  Scene scene = scene_of(pot);
  prescribe(scene.tools[0], "outer", core::TimeFunction(core::Table{{0, 0.4}, {753.15, 653.15}}));
  scene.stages[0].duration = 0.05;
  scene.stages.push_back(scene.stages[0]);
  const auto outcome = run(scene, {});
  ASSERT_TRUE(outcome.facts.completed) << outcome.facts.reason;
  EXPECT_NEAR(outcome.state.time, 0.1, 1e-9);
  EXPECT_LT(max_difference(outcome.state.tools[0].mesh, outcome.state.tools[0].temperature, "outer", 728.15), 1e-6);
}

}  // namespace
}  // namespace parison::forming
