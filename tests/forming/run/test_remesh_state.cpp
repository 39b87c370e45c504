// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../pot_scene.hpp"
#include "../scene_text.hpp"
#include "contact/unilateral/tool_gap.hpp"
#include "figure.hpp"
#include "forming/remeshing/remesh_criteria.hpp"
#include "forming/remeshing/remesh_state.hpp"
#include "forming/remeshing/tool_corners.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/penetration.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "remesh/mesher/quality.hpp"
#include "remesh/sizing/recovery.hpp"

namespace parison::forming {
namespace {

class RemeshState : public ::testing::Test {
 protected:
  Scene scene;

  /// The pot pressed until it is full, with a new mesh whenever a cell is worse than 0.6.
  State pressed(const std::string& more) {
    scene = scene_of(pot + "quality_floor = 0.6\n" + more);
    RunOutcome outcome = run_in_folder(scene, tests::absent_folder(), {});
    EXPECT_TRUE(outcome.facts.completed) << outcome.facts.reason;
    return outcome.state;
  }

  /// Share of the surface nodes off the axis that lie on a tool.
  double share_on_tools(const State& state) const {
    const Eigen::VectorXd pot_gap = tool_gaps(scene, state, 0, 1e-3), face_gap = tool_gaps(scene, state, 1, 1e-3);
    double on = 0, all = 0;
    for (const Index node : surface_nodes(state.glass.mesh)) {
      if (state.glass.mesh.nodes[node][0] == 0) continue;
      all += 1;
      on += std::min(pot_gap[node], face_gap[node]) < 10e-6;
    }
    return on / all;
  }

  void expect_kept(const State& before, const State& after) const {
    const auto volume = [&](const State& state) { return core::volume(state.glass.mesh, scene.geometry); };
    EXPECT_NEAR(volume(after) / volume(before), 1, 1e-12);
    EXPECT_NEAR(glass_heat(scene, after) / glass_heat(scene, before), 1, 1e-12);
    const auto &cold = before.glass.temperature, &now = after.glass.temperature;
    EXPECT_GT(cold.maxCoeff() - cold.minCoeff(), 100) << "no skin to overshoot at";
    EXPECT_LE(now.maxCoeff(), cold.maxCoeff() + 1e-9);
    EXPECT_GE(now.minCoeff(), cold.minCoeff() - 1e-9);
    EXPECT_LE(deepest_node(scene, after).depth, deepest_node(scene, before).depth + 5e-6);
  }

  static void expect_clean_statistics(const State& state) {
    const RemeshStatistics& statistics = state.totals.remeshing;
    EXPECT_GE(remeshes(state), 3);
    tests::expect_at_most("full cavity: volume changed by one remesh",
                          statistics.max_volume / state.glass.initial_volume, 1e-12);
    tests::expect_at_most("full cavity: heat changed by all remeshes",
                          std::abs(statistics.heat) / state.glass.initial_heat, 1e-9);
    tests::expect_at_most("full cavity: new extreme of temperature", statistics.transfer_overshoot, 1e-9, "K");
    EXPECT_LE(std::abs(statistics.volume) / state.glass.initial_volume, 1e-9);
  }
};

TEST_F(RemeshState, a_full_cavity_keeps_volume_heat_and_temperature_range_and_is_not_pressed_into_the_tools) {
  const State state = pressed("");
  EXPECT_GT(share_on_tools(state), 0.95);
  const RemeshedState remeshed = remesh_state(scene, state, RemeshReason::quality);
  ASSERT_TRUE(remeshed.ok) << remeshed.reason;
  expect_kept(state, remeshed.state);
  expect_clean_statistics(remeshed.state);
}

TEST_F(RemeshState, a_surface_found_inside_a_tool_is_lifted_out_and_its_volume_given_back) {
  State state = pressed("");
  state.tools[1].offset += 1e-3;   // frees the upper face
  state.tools[0].offset += 20e-6;  // the bottom now lies 20 micrometres inside the pot
  const double depth = deepest_node(scene, state).depth;
  EXPECT_GT(depth, 15e-6);
  const RemeshedState remeshed = remesh_state(scene, state, RemeshReason::quality);
  ASSERT_TRUE(remeshed.ok) << remeshed.reason;
  expect_kept(state, remeshed.state);
  EXPECT_LT(deepest_node(scene, remeshed.state).depth, 1e-6);
}

TEST_F(RemeshState, contact_that_has_just_begun_is_no_contact_of_the_step_before_on_the_new_mesh) {
  scene = scene_of(pot);
  State state = initial_state(scene);
  for (const Index node : contact_nodes(state.glass.mesh)) state.glass.contact_tool[node] = 0;
  state.glass.previous_contact_tool.assign(state.glass.contact_tool.size(), -1);
  const RemeshedState remeshed = remesh_state(scene, state, RemeshReason::quality);
  ASSERT_TRUE(remeshed.ok) << remeshed.reason;
  const GlassState& glass = remeshed.state.glass;
  EXPECT_GT(std::count(glass.contact_tool.begin(), glass.contact_tool.end(), 0), 0);
  EXPECT_EQ(std::count(glass.previous_contact_tool.begin(), glass.previous_contact_tool.end(), -1),
            glass.mesh.node_count());
}

TEST_F(RemeshState, an_edge_that_bulges_round_a_corner_of_the_tools_becomes_the_corner) {
  const std::string square = "(0, 0) (10, 0) (10, 10) (0, 10) mm";
  for (const std::string edge : {"(11.7, 0) (12, 1.4)", "(10.6, 0) (12, 0.3)", "(11.5, 0) (12, 0.5)"}) {
    const std::string chamfered = "(0, 0) " + edge + " (12, 10) (0, 10) mm";
    scene = scene_of(replaced(square, chamfered, pot + "surface_size = \"1.8 mm\"\n"));
    State state = initial_state(scene);
    GlassState& glass = state.glass;
    for (const auto& side : glass.mesh.boundary_edges()) {
      const Point along = glass.mesh.nodes[side.nodes[1]] - glass.mesh.nodes[side.nodes[0]];
      if (!(along[0] > 1e-4 && along[1] > 1e-4)) continue;
      glass.mesh.nodes[side.nodes[2]] = Point(12e-3, 0);
      for (const Index node : side.nodes) glass.contact_tool[node] = 0;
    }
    EXPECT_LT(deepest_node(scene, state).depth, 1e-12) << "a node shows what the edge does";
    EXPECT_GT(deepest_edge(scene, state).depth, 5e-5) << edge;
    for (const double known : {0.0, 1e-9, 1e-3})
      EXPECT_EQ(deepest_edge(scene, state, known).depth, std::max(known, deepest_edge(scene, state).depth));
    for (Index n = 0; n < glass.mesh.node_count(); ++n) glass.temperature[n] += 2e4 * glass.mesh.nodes[n][1];
    const RemeshedState remeshed = remesh_state(scene, state, RemeshReason::quality);
    ASSERT_TRUE(remeshed.ok) << edge << ": " << remeshed.reason;
    expect_kept(state, remeshed.state);
    EXPECT_LT(deepest_edge(scene, remeshed.state).depth, 0.1 * deepest_edge(scene, state).depth) << edge;
    EXPECT_GE(remesh::quality(remeshed.state.glass.mesh).min, 0.3) << edge;
  }
}

/// A disc on a base, whose wall stands a little off the disc.
const std::string beside_a_wall = R"(case = "beside"
geometry = "axisymmetric"
material.liquid = { density = "2400 kg/m3", viscosity = { law = "constant", value = "1e5 Pa.s" } }
stage = [{ name = "rest", duration = "1 s", gravity = "-9.81 m/s2", tools = ["base", "wall"] }]
[glass]
material = "liquid"
boundary = [
  { name = "surface", condition = "contact", path = "(0, 0) (7.34, 0) (7.34, 10) (0, 10) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" },
]
[[tool]]
name = "base"
friction = "slip"
boundary = [
  { name = "top", condition = "contact", path = "(22, 0) (0, 0) mm" },
  { name = "axis", condition = "symmetry", path = "(0, -4) mm" },
  { name = "rest", condition = "insulated", path = "(22, -4) (22, 0) mm" },
]
[[tool]]
name = "wall"
friction = "slip"
boundary = [
  { name = "inner", condition = "contact", path = "(7.38, 40) (7.38, -20) mm" },
  { name = "rest", condition = "insulated", path = "(29, -20) (29, 40) (7.38, 40) mm" },
]
)";

TEST_F(RemeshState, a_corner_of_tools_that_the_glass_has_not_reached_takes_none_of_it) {
  scene = scene_of(beside_a_wall, "standard");
  const State state = initial_state(scene);
  const RemeshedState remeshed = remesh_state(scene, state, RemeshReason::quality);
  ASSERT_TRUE(remeshed.ok) << remeshed.reason;
  double widest = 0;
  for (const Point& x : remeshed.state.glass.mesh.nodes) widest = std::max(widest, x[0]);
  EXPECT_NEAR(widest, 7.34e-3, 1e-9);
}

TEST_F(RemeshState, an_edge_over_a_ridge_of_the_tool_is_as_deep_as_the_ridge_wherever_it_lies) {
  scene = scene_of(replaced("(12, 20) (12, 0) (0, 0) mm",
                            "(12, 20) (12, -0.2) (4.23, -0.2) (4.03, 0) (3.83, -0.2) (0, -0.2) mm", pot));
  State state = initial_state(scene);
  constexpr double depth = 30e-6;
  for (Point& node : state.glass.mesh.nodes) node[1] -= depth;
  for (const Index node : contact_nodes(state.glass.mesh)) state.glass.contact_tool[node] = 0;
  EXPECT_LT(deepest_node(scene, state).depth, 1e-12) << "no node is at the ridge";
  EXPECT_NEAR(deepest_edge(scene, state).depth, depth / std::sqrt(2), 1e-9) << "from its two sides";
  state.time = 0.25;
  GlassInTools seen;
  follow_glass_in_tools(scene, state, seen);
  state.time = 0.5;
  for (Point& node : state.glass.mesh.nodes) node[1] += 0.5 * depth;
  follow_glass_in_tools(scene, state, seen);
  EXPECT_EQ(place_of_penetration(scene, seen.node), "");
  EXPECT_EQ(place_of_penetration(scene, seen.edge),
            "the deepest, 0.0212 mm, in pot at (r, z) = (4.03, -0.03) mm after 0.25 s");
}

TEST_F(RemeshState, a_corner_of_a_tool_that_another_tool_covers_asks_for_no_vertex) {
  scene = read_scene(std::string(PARISON_SOURCE_DIR) + "/cases/tumbler", "draft");
  State state = initial_state(scene);
  for (const double down : {0.0, 20e-3, 60e-3}) {
    for (std::size_t t = 0; t < scene.tools.size(); ++t)
      if (scene.tools[t].name == "plunger") state.tools[t].offset = -down;
    const auto corners = tool_corners(scene, state);
    EXPECT_GE(corners.size(), 4u);
    for (const auto& place : scene.stages[0].tools)
      for (const Point& corner : corners) {
        const Body& tool = scene.tools[place.tool];
        const Point local = corner - state.tools[place.tool].offset * core::axis_direction();
        EXPECT_GE(contact::signed_gap(tool.profile, contact_boundaries(tool), local), -1e-5)
            << tool.name << " at " << down;
      }
  }
}

}  // namespace
}  // namespace parison::forming
