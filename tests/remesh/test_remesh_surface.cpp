// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that a new mesh has to mend: bulges into tools, collapsed edges, laps.
#include <gtest/gtest.h>

#include <algorithm>

#include "remesh/glass_meshes.hpp"
#include "remesh/mesher/quality.hpp"
#include "remesh/profiles.hpp"
#include "remesh/remesh_glass.hpp"

namespace parison::remesh {
namespace {

/// A block whose edge from `start` to `end` bends through `mid`, into a tool with a corner.
struct Bulge {
  Point start, mid, end, corner;
  ExteriorProjection project_out;
};

void expect_led_out(const Bulge& bulge) {
  const Point &start = 1e3 * bulge.start, &end = 1e3 * bulge.end;
  Pen pen(0, 0);
  if (start[1] > 0) pen.line(start[0], 0, "outer");
  const core::Profile block = pen.line(start[0], start[1], "outer")
                                  .line(end[0], end[1], "outer")
                                  .line(end[0], 10, "outer")
                                  .line(0, 10, "outer")
                                  .line(0, 0, "axis")
                                  .closed();
  Mesh old = meshed(block, 2.5e-3);
  for (const auto& edge : old.boundary_edges())
    if ((old.nodes[edge.nodes[0]] - bulge.start).norm() < 1e-9) old.nodes[edge.nodes[2]] = bulge.mid;
  Criteria criteria = criteria_for(old, 1.8e-3);
  criteria.geometry = core::Geometry::planar;
  criteria.skin_size = criteria.min_size = 0.35e-3;
  criteria.keep = {bulge.corner};
  const auto deepest = [&](const Mesh& mesh) {
    double depth = 0;
    for (const Point& x : mesh.nodes) depth = std::max(depth, (bulge.project_out(x) - x).norm());
    return depth;
  };
  EXPECT_EQ(deepest(old), 0) << "a node shows what the edge does";
  EXPECT_GT(deepest(remesh_glass(old, criteria).mesh), 0.05e-3) << "no bulge";
  criteria.project_out = bulge.project_out;
  const Remeshed made = remesh_glass(old, criteria);
  ASSERT_TRUE(made.ok) << made.reason;
  EXPECT_LT(deepest(made.mesh), 15e-6);
  EXPECT_GE(quality(made.mesh).min, 0.3);
  EXPECT_NEAR(made.volume_after / made.volume_before, 1, 1e-13);
  double nearest = 1;
  for (Index i = 0; i < made.mesh.vertex_count(); ++i)
    nearest = std::min(nearest, (made.mesh.nodes[i] - bulge.corner).norm());
  EXPECT_LT(nearest, 15e-6);
}

TEST(RemeshGlass, a_bulge_into_a_tool_is_led_out_before_the_inside_is_meshed) {
  const Point hollow(12e-3, 0), sharp(11.8e-3, 3e-3);
  expect_led_out({{11.7e-3, 0}, hollow, {12e-3, 1.4e-3}, hollow, [](const Point& x) {
                    return Point(std::min(x[0], 12e-3), std::max(x[1], 0.0));
                  }});
  expect_led_out({{11.8e-3, 2e-3}, {12.3e-3, 3.02e-3}, {13e-3, 3.3e-3}, sharp, [=](const Point& x) -> Point {
                    const Point in(x[0] - sharp[0], sharp[1] - x[1]);
                    if (in[0] <= 0 || in[1] <= 0) return x;
                    return in[0] < in[1] ? Point(sharp[0], x[1]) : Point(x[0], sharp[1]);
                  }});
}

TEST(RemeshGlass, an_edge_whose_ends_met_in_a_corner_is_left_out) {
  const Mesh whole = meshed(gob(), 2e-3);
  const Criteria criteria = criteria_for(whole, 2e-3);
  const Index axis = core::find_boundary(whole, "axis");
  const auto count = static_cast<Index>(whole.boundary_edges().size());
  const auto on_axis = [&](Index i) { return whole.boundary_edges()[(i + count) % count].boundary_id == axis; };
  for (Index i = 0; i < count; ++i) {
    if (on_axis(i)) continue;
    Mesh old = whole;
    const auto& nodes = old.boundary_edges()[i].nodes;
    const int kept = on_axis(i + 1) ? 1 : 0;  // beside the axis the end of the boundary stays
    old.nodes[nodes[1 - kept]] = old.nodes[nodes[kept]];
    const Remeshed made = remesh_glass(old, criteria);
    ASSERT_TRUE(made.ok) << i << ": " << made.reason;
    EXPECT_GE(quality(made.mesh).min, 0.3) << i;
    EXPECT_NEAR(made.volume_after / made.volume_before, 1, 1e-13) << i;
    EXPECT_EQ(boundary_ends(made.mesh), boundary_ends(whole)) << i;
  }
}

/// The gob with a notch of a depth in its side, m, whose flanks have passed through each other by a tenth of their
/// distance.
Mesh lapped_gob(double depth) {
  Mesh mesh = meshed(gob(), 2e-3);
  std::size_t at = 0;
  for (std::size_t i = 0; i < mesh.boundary_edges().size(); ++i)
    if (mesh.nodes[mesh.boundary_edges()[i].nodes[0]][0] > mesh.nodes[mesh.boundary_edges()[at].nodes[0]][0]) at = i;
  const auto &before = mesh.boundary_edges()[at - 1].nodes, &after = mesh.boundary_edges()[at].nodes;
  const Point a = mesh.nodes[before[0]], b = mesh.nodes[after[1]], along = 0.1 * (b - a), middle = 0.5 * (a + b);
  mesh.nodes[after[0]] = middle - Point(depth, 0);
  mesh.nodes[before[2]] = middle - Point(0.5 * depth, 0) + along;
  mesh.nodes[after[2]] = middle - Point(0.5 * depth, 0) - along;
  return mesh;
}

TEST(RemeshGlass, a_little_lap_is_closed_and_a_great_one_reported) {
  const Mesh little = lapped_gob(0.2e-3), great = lapped_gob(18e-3);
  const Remeshed closed = remesh_glass(little, criteria_for(little, 2e-3));
  ASSERT_TRUE(closed.ok) << closed.reason;
  EXPECT_EQ(closed.laps, 1);
  EXPECT_GT(closed.lap_volume, 0);
  EXPECT_LT(closed.lap_volume, 4e-3 * closed.volume_before);
  EXPECT_GE(quality(closed.mesh).min, 0.3);
  EXPECT_NEAR(closed.volume_after / closed.volume_before, 1, 1e-13);
  EXPECT_EQ(boundary_ends(closed.mesh), boundary_ends(little));
  const Remeshed left = remesh_glass(great, criteria_for(great, 2e-3));
  EXPECT_FALSE(left.ok);
  EXPECT_NE(left.reason.find("in a lap of more than"), std::string::npos) << left.reason;
}

TEST(RemeshGlass, a_surface_that_crosses_itself_is_reported) {
  const Mesh old = deformed(meshed(cup(6), 1.5e-3), [](const Point& x) {
    return x[1] < 20e-3 ? Point(x[0] + 0.8 * (20e-3 - x[1]) * (28e-3 - x[0]) / 3e-3, x[1]) : x;
  });
  const Remeshed made = remesh_glass(old, criteria_for(old, 1.5e-3));
  EXPECT_FALSE(made.ok);
  EXPECT_NE(made.reason.find("crosses itself"), std::string::npos) << made.reason;
}

}  // namespace
}  // namespace parison::remesh
