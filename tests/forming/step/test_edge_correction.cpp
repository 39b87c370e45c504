// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../scene_text.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/edge_correction.hpp"
#include "forming/step/contact/penetration.hpp"

namespace parison::forming {
namespace {

/// Glass whose bottom, at z = 0, lies over a tool with a ridge that rises to z = 0 between nodes and turns by 11
/// degrees.
const std::string ridge = R"(case = "ridge"
geometry = "axisymmetric"
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e3 Pa.s" }
[glass]
material = "liquid"
boundary = [
  { name = "surface", condition = "contact", path = "(0, 0) (10, 0) (10, 10) (0, 10) mm" },
  { name = "axis", condition = "symmetry", path = "(0, 0) mm" } ]
[[tool]]
name = "tool"
friction = "slip"
boundary = [
  { name = "face", condition = "contact", path = "(20, -5) (20, -1.587) (4.13, 0) (0, -0.413) mm" },
  { name = "axis", condition = "symmetry", path = "(0, -5) mm" },
  { name = "rest", condition = "insulated", path = "(20, -5) mm" } ]
[[stage]]
name = "wait"
duration = "1 s"
tools = ["tool"]
[numerics]
surface_size = "2 mm"
)";

/// The glass, 10 um of it pressed over the ridge, whose nodes all touch.
struct OnRidge {
  Scene scene = scene_of(ridge);
  State state = initial_state(scene);
  double allowed = core::tolerance::at_tool * core::size(scene.glass.profile);
  OnRidge() {
    for (Point& node : state.glass.mesh.nodes) node[1] -= 10e-6;
    for (const Index node : contact_nodes(state.glass.mesh))
      if (state.glass.mesh.nodes[node][1] < 0) state.glass.contact_tool[node] = 0;
  }
};

TEST(EdgeCorrection, an_edge_over_a_ridge_is_moved_out_and_the_volume_stays) {
  OnRidge glass;
  const core::Mesh before = glass.state.glass.mesh;
  ASSERT_LT(deepest_node(glass.scene, glass.state).depth, 1e-12) << "no node is at the ridge";
  const double depth = deepest_edge(glass.scene, glass.state).depth;
  ASSERT_GT(depth, 10 * glass.allowed);
  correct_edges(glass.scene, glass.state);
  const core::Mesh& after = glass.state.glass.mesh;
  constexpr double for_volume = 2e-6;  // m, shift of the surface, none of which rests on the tool here
  EXPECT_LT(deepest_edge(glass.scene, glass.state).depth, 1.05 * glass.allowed + for_volume);
  EXPECT_LT(deepest_node(glass.scene, glass.state).depth, glass.allowed);
  const double volume = core::volume(before, glass.scene.geometry);
  EXPECT_NEAR(core::volume(after, glass.scene.geometry) / volume, 1, 1e-13);
  for (Index n = 0; n < after.vertex_count(); ++n)
    EXPECT_LT((after.nodes[n] - before.nodes[n]).norm(), for_volume) << "vertices only follow the volume";
}

TEST(EdgeCorrection, edges_outside_the_tools_and_edges_that_touch_none_stay_to_the_bit) {
  OnRidge glass;
  core::Mesh& mesh = glass.state.glass.mesh;
  const std::vector<Index> none(mesh.nodes.size(), -1);
  const core::Mesh before = mesh;
  EXPECT_FALSE(move_edges_out(glass.scene, glass.state, none, mesh));
  EXPECT_EQ(mesh.nodes, before.nodes);
  for (Point& node : mesh.nodes) node[1] += 10e-6;
  const core::Mesh lifted = mesh;
  correct_edges(glass.scene, glass.state);
  EXPECT_EQ(mesh.nodes, lifted.nodes);
}

TEST(EdgeCorrection, a_step_that_leaves_an_edge_deep_in_a_tool_is_told_from_one_that_found_it_there) {
  OnRidge glass;
  State outside = glass.state, corrected = glass.state;
  for (Point& node : outside.glass.mesh.nodes) node[1] += 10e-6;
  move_edges_out(glass.scene, corrected, corrected.glass.contact_tool, corrected.glass.mesh);
  const double depth = deepest_edge(glass.scene, glass.state).depth;
  EXPECT_EQ(edge_depth_gained(glass.scene, outside, glass.state), depth);
  EXPECT_EQ(edge_depth_gained(glass.scene, glass.state, glass.state), 0) << "it was there before";
  State creeping = glass.state;
  for (Point& node : creeping.glass.mesh.nodes)
    node[1] -= 0.1 * core::tolerance::penetration * core::size(glass.scene.glass.profile);
  EXPECT_GT(deepest_edge(glass.scene, creeping).depth, depth);
  EXPECT_EQ(edge_depth_gained(glass.scene, glass.state, creeping), 0) << "shorter steps would not end";
  EXPECT_GT(deepest_edge(glass.scene, corrected).depth, 0);
  EXPECT_EQ(edge_depth_gained(glass.scene, outside, corrected), 0) << "no deeper than a corrected edge";
  const double size = core::size(glass.scene.glass.profile), step = core::tolerance::penetration * size;
  State beyond = glass.state;
  for (Point& node : beyond.glass.mesh.nodes) node[1] += depth - core::tolerance::at_tool * size - 1.5 * step;
  EXPECT_GT(edge_depth_gained(glass.scene, outside, beyond), 0) << "deeper than a corrected edge by half a step";
}

TEST(EdgeCorrection, the_flow_does_not_press_an_edge_back_that_was_moved_out) {
  OnRidge glass;
  const core::Mesh before = glass.state.glass.mesh;
  ASSERT_TRUE(move_edges_out(glass.scene, glass.state, glass.state.glass.contact_tool, glass.state.glass.mesh));
  const core::Mesh& after = glass.state.glass.mesh;
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(core::dim * after.node_count());
  int moved = 0;
  for (const auto& candidate : contact_candidates(glass.scene, glass.state, at_rest, 1e-3)) {
    if ((after.nodes[candidate.node] - before.nodes[candidate.node]).norm() < 1e-9) continue;
    ++moved;
    EXPECT_NEAR(candidate.rate, 0, 1e-9);
  }
  EXPECT_GE(moved, 1);
}

/// The scene with a round tool, of 3 mm radius, under the glass, and heat.
std::string with_round_tool() {
  std::string text = ridge;
  const auto put = [&](const std::string& from, const std::string& to) {
    text.replace(text.find(from), from.size(), to);
  };
  put(R"("(20, -5) (20, -1.587) (4.13, 0) (0, -0.413) mm")",
      R"(["(20, -20) (20, -3) (3, -3) mm", "arc centre (0, -3) mm radius 3 mm from 0 deg to 90 deg"])");
  put(R"("(0, -5) mm")", R"("(0, -20) mm")");
  put(R"("(20, -5) mm")", R"("(20, -20) mm")");
  put("\"2 mm\"", "\"1 mm\"");
  put("viscosity =", "heat_capacity = \"1300 J/kg/K\"\nconductivity = \"2 W/m/K\"\nviscosity =");
  put("material = \"liquid\"", "material = \"liquid\"\ntemperature = \"900 degC\"");
  put("friction = \"slip\"", "friction = \"slip\"\nmaterial = \"iron\"\ntemperature = \"500 degC\"");
  return text + iron + "[[interface]]\ntools = [\"tool\"]\nlaw = \"constant\"\nh = \"1000 W/m2/K\"\n";
}

TEST(EdgeCorrection, a_middle_that_is_off_the_middle_of_an_edge_on_a_round_tool_slides_back_along_it_with_its_field) {
  const Scene scene = scene_of(with_round_tool());
  State state = initial_state(scene);
  GlassState& glass = state.glass;
  const auto& edges = glass.mesh.boundary_edges();
  const auto edge = std::find_if(edges.begin(), edges.end(), [&](const core::BoundaryEdge& e) {
    return glass.mesh.nodes[e.nodes[0]][0] < 1e-9 && glass.mesh.nodes[e.nodes[2]][1] < 1e-9;
  });
  ASSERT_NE(edge, edges.end()) << "on the bottom, at the axis";
  const auto [first, last, middle] = edge->nodes;
  const double length = glass.mesh.nodes[last][0];
  const auto on_tool = [](double r) { return Point(r, -3e-3 + std::sqrt(9e-6 - r * r)); };
  constexpr double off = 0.1;
  glass.mesh.nodes[last] = on_tool(length), glass.mesh.nodes[middle] = on_tool((0.5 - off) * length);
  for (const Index node : edge->nodes) glass.contact_tool[node] = 0;
  glass.temperature[last] += 50, glass.temperature[middle] += 10;
  glass.mass_nodes = glass.mesh.nodes;
  const State before = state;
  const double depth = deepest_edge(scene, state).depth;
  ASSERT_GT(depth, 5e-6);
  ASSERT_TRUE(centre_middles(scene, state));
  EXPECT_NEAR(glass.mesh.nodes[middle][0], 0.5 * length, 0.05 * length);
  EXPECT_EQ(glass.mass_nodes[middle], glass.mesh.nodes[middle]);
  EXPECT_NEAR(glass_heat(scene, state), glass_heat(scene, before), 1e-12 * glass_heat(scene, before));
  // The field along the old edge was 41.7 s^2 + 8.3 s K at the share s of its length.
  EXPECT_NEAR(glass.temperature[middle] - glass.temperature[first], 14.6, 0.5);
  const core::Mesh mass = mass_mesh(state), mass_before = mass_mesh(before);
  EXPECT_NEAR(glass.density * core::volume(mass, scene.geometry),
              before.glass.density * core::volume(mass_before, scene.geometry), 1e-18);
  // On the old edge the node lies in the tool a little; moved out of it, it is on the arc, and so is the edge.
  EXPECT_TRUE(move_edges_out(scene, state, glass.contact_tool, glass.mesh));
  EXPECT_LT(deepest_edge(scene, state).depth, 0.25 * depth);
  EXPECT_FALSE(centre_middles(scene, state)) << "once is enough";
}

}  // namespace
}  // namespace parison::forming
