// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "core/mesh/element.hpp"
#include "figure.hpp"
#include "forming/report/container/container_report.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/balance/cold_glass.hpp"

namespace parison::forming {
namespace {

/// A cup of glass, open above, 4 mm outside and 3 mm inside, 20 mm high on 1 mm of bottom, in a mould without a lid.
Scene cup_in_an_open_mould(const std::string& gravity, const std::string& density = "density = \"2400 kg/m3\"\n",
                           const std::string& temperature = "") {
  return scene_of(R"(case = "cup"
geometry = "axisymmetric"
output.fill_level = "5 mm"
[material.soft]
)" + density + R"(viscosity = { law = "constant", value = "1e4 Pa.s" }
[glass]
)" + temperature + R"(material = "soft"
boundary = [
  { name = "outer", path = "(0, 0) (4, 0) (4, 20) mm", condition = "contact" },
  { name = "top", path = "(3, 20) mm", condition = "air" },
  { name = "inner", path = "(3, 1) (0, 1) mm", condition = "air" },
  { name = "axis", path = "(0, 0) mm", condition = "symmetry" },
]
[[tool]]
name = "mould"
friction = "stick"
boundary = [
  { name = "cavity", path = "(6, 20) (6, 0) (0, 0) mm", condition = "contact" },
  { name = "axis", path = "(0, -5) mm", condition = "symmetry" },
  { name = "outer", path = "(20, -5) (20, 20) (6, 20) mm", condition = "insulated" },
]
[[stage]]
name = "blow"
duration = "1 s"
tools = ["mould"]
gravity = ")" + gravity +
                  R"("
pressure.inner = "1 bar"
)");
}

TEST(ContainerReport, what_a_blown_wall_holds_is_given_where_no_tool_closes_the_mouth_of_the_mould) {
  const Scene scene = cup_in_an_open_mould("-9.81 m/s2");
  ASSERT_FALSE(plan_container(scene)->capacity) << "the drawings do not say";
  const auto report = container_report(scene, initial_state(scene), true);
  ASSERT_TRUE(report && report->capacity && report->filled);
  EXPECT_NEAR(1e9 * *report->capacity, M_PI * 9 * 19, 0.01);
  EXPECT_NEAR(1e9 * *report->filled, M_PI * 9 * 14, 0.01);
  EXPECT_EQ(capacity_text(scene, initial_state(scene), true), "0.5372 ml to the rim, 0.3958 ml to 5 mm below it");
  EXPECT_EQ(capacity_text(scene, initial_state(scene), false), "") << "a gob";
}

TEST(ContainerReport, a_container_of_one_temperature_shrinks_alike_to_20_degC) {
  const Scene scene = cup_in_an_open_mould(
      "-9.81 m/s2",
      "expansion = { cold_density = \"2520 kg/m3\", solid = \"9e-6 1/K\", liquid = \"32e-6 1/K\", transformation = "
      "\"550 degC\" }\n",
      "temperature = \"700 degC\"\n");
  const State state = initial_state(scene);
  const auto report = container_report(scene, state, true);
  ASSERT_TRUE(report && report->capacity && report->cold && report->cold->capacity && report->cold->filled);
  const double length = std::exp(9e-6 * 530 + 32e-6 * 150);
  EXPECT_NEAR(report->cold->contraction, length - 1, 1e-7);
  EXPECT_NEAR(1e3 * report->size.height, 20, 1e-9);
  EXPECT_NEAR(1e3 * report->size.diameter, 8, 1e-9);
  EXPECT_NEAR(1e3 * report->cold->size.height * length, 20, 1e-5);
  EXPECT_NEAR(1e3 * report->cold->size.diameter * length, 8, 1e-5);
  EXPECT_NEAR(*report->cold->capacity * std::pow(length, 3) / *report->capacity, 1, 1e-6);
  EXPECT_LT(*report->cold->filled, *report->cold->capacity);
  EXPECT_NE(capacity_text(scene, state, true)
                .find("; 20 mm high and 8 mm wide, at 20 degC 19.81 and 7.924 mm, 0.5220 ml, contraction 0.96 %"),
            std::string::npos)
      << capacity_text(scene, state, true);
  EXPECT_FALSE(container_report(cup_in_an_open_mould("-9.81 m/s2"), state, true)->cold);
}

/// Volume that a boundary turns round the axis, by Pappus over its quadratic edges, m3.
double turned_volume(const core::Mesh& mesh, const std::string& boundary) {
  double volume = 0;
  for (const auto& edge : mesh.boundary_edges()) {
    if (edge.boundary_id != core::find_boundary(mesh, boundary)) continue;
    const Point a = mesh.nodes[edge.nodes[0]], b = mesh.nodes[edge.nodes[1]], middle = mesh.nodes[edge.nodes[2]];
    for (const auto& rule : core::edge_rule(4)) {
      const auto shape = core::edge_shape(rule.s), slope = core::edge_shape_derivative(rule.s);
      const double r = shape[0] * a[0] + shape[1] * b[0] + shape[2] * middle[0];
      const double rise = slope[0] * a[1] + slope[1] * b[1] + slope[2] * middle[1];
      volume += rule.weight * M_PI * r * r * rise;
    }
  }
  return std::abs(volume);
}

TEST(ContainerReport, the_cold_capacity_is_the_volume_inside_the_cold_surface) {
  const Scene scene = cup_in_an_open_mould(
      "-9.81 m/s2",
      "expansion = { cold_density = \"2520 kg/m3\", solid = \"9e-6 1/K\", liquid = \"32e-6 1/K\", transformation = "
      "\"550 degC\" }\n",
      "temperature = \"700 degC\"\nmesh = { size = \"0.2 mm\" }\n");
  State state = initial_state(scene);
  for (Index n = 0; n < state.glass.mesh.node_count(); ++n) {  // a bottle of 200 ml, hotter below and within
    Point& x = state.glass.mesh.nodes[n];
    const double height = 1e3 * x[1], neck = 0.5 * (1 + std::tanh((height - 14) / 2));
    state.glass.temperature[n] += 10 * (20 - height) + 100 * std::cos(1e3 * x[0]);
    x = Point(x[0] * (10 - 5.5 * neck), 5 * x[1]);
  }
  const auto report = container_report(scene, state, true);
  const auto cold = cold_glass(scene, state);
  ASSERT_TRUE(report && report->capacity && report->cold && report->cold->capacity && cold);
  tests::Figure error("capacity of a cold container against the volume inside its surface, of bottle size: off by");
  error.add(std::abs(*report->capacity / turned_volume(state.glass.mesh, "inner") - 1));
  error.add(std::abs(*report->cold->capacity / turned_volume(*cold, "inner") - 1));
  EXPECT_LT(*report->cold->capacity, 0.98 * *report->capacity);
  error.at_most(1e-4);
}

TEST(ContainerReport, a_wall_whose_capacity_cannot_be_computed_is_told_why) {
  const Scene lying = cup_in_an_open_mould("0 m/s2");
  EXPECT_EQ(capacity_text(lying, initial_state(lying), true),
            "not computed: the last stage has no gravity, so it is not known which way up the container stands");
  const Scene upside_down = cup_in_an_open_mould("9.81 m/s2");
  EXPECT_EQ(capacity_text(upside_down, initial_state(upside_down), true),
            "not computed: as the glass stands, no hollow was found that would hold a liquid; it is open below, or its "
            "wall too thin or its mesh too fine to tell");
  core::JsonWriter json;
  add_container(json, upside_down, initial_state(upside_down), true);
  EXPECT_NE(json.finish().find("\"capacity_absent\": \"not computed: "), std::string::npos);
}

TEST(ContainerReport, the_drawn_volume_at_the_fill_level_is_given_where_the_formed_one_differs) {
  const Scene scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/jar", "draft",
                                 {"output.fill_level=20 mm", "material.flint.density=2400 kg/m3"});
  const auto plan = plan_container(scene);
  ASSERT_TRUE(plan->capacity && plan->filled);
  State state = initial_state(scene);
  // The glass is a cup as wide as the finish, so that it holds something else than the jar.
  Scene cup = cup_in_an_open_mould("9.81 m/s2");
  state.glass = initial_state(cup).glass;
  for (Point& x : state.glass.mesh.nodes) x = Point(8 * x[0], 1e-3 - 4 * x[1]);
  const std::string text = capacity_text(scene, state, true);
  const auto drawn = text.rfind(", drawn ");
  ASSERT_NE(drawn, text.npos) << text;
  EXPECT_NE(text.find("ml to 20 mm below it, drawn "), text.npos) << text;
  EXPECT_NEAR(std::stod(text.substr(drawn + 8)), 1e6 * *plan->filled, 0.006) << text;
}

}  // namespace
}  // namespace parison::forming
