// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/profiles.hpp"
#include "remesh/remesh_glass.hpp"
#include "remesh/surface/axis_closing.hpp"

namespace parison::remesh {
namespace {

using core::Index;
using core::Mesh;
using core::Point;

Mesh cylinder() {
  const core::Profile profile =
      Pen(0, 0).line(10, 0, "surface").line(10, 10, "surface").line(0, 10, "surface").line(0, 0, "axis").closed();
  Mesh mesh = mesh_profile(profile, {1e-3, 1e-3, 0.3, std::vector<bool>(profile.boundary_names.size(), false)});
  for (auto& boundary : mesh.edit().boundaries)
    boundary.kind = boundary.name == "axis" ? core::BoundaryKind::symmetry : core::BoundaryKind::contact;
  return mesh;
}

/// A cylinder of glass, 10 mm wide and high, whose top has risen around the axis: the vertex next to the upper end of
/// the axis stands 1 mm higher, at the axis.
Mesh curtain() {
  Mesh mesh = cylinder();
  for (const auto& edge : mesh.boundary_edges()) {
    const auto& [first, last, middle] = edge.nodes;
    if ((mesh.nodes[last] - Point(0, 10e-3)).norm() > 1e-9 || mesh.kind_of(edge) == core::BoundaryKind::symmetry)
      continue;
    mesh.nodes[first] = {0, 11e-3};
    mesh.nodes[middle] = {0.2e-3, 10.5e-3};
  }
  return mesh;
}

double end_of_axis(const Mesh& mesh) {
  double end = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) == core::BoundaryKind::symmetry)
      for (const Index n : edge.nodes) end = std::max(end, mesh.nodes[n][1]);
  return end;
}

TEST(AxisClosing, free_surface_that_has_come_to_the_axis_becomes_axis) {
  const Mesh mesh = curtain();
  ASSERT_TRUE(has_reached_axis(mesh));
  const ClosedOnAxis closed = close_on_axis(mesh, 1e-9);
  EXPECT_EQ(closed.voids, 1);
  EXPECT_FALSE(has_reached_axis(closed.mesh));
  EXPECT_DOUBLE_EQ(end_of_axis(closed.mesh), 11e-3);
  // Two cones on a circle of 0.2 mm, 0.5 mm high.
  EXPECT_NEAR(closed.volume, M_PI / 3 * 0.04e-6 * 1e-3, 1e-18);
}

TEST(AxisClosing, a_void_greater_than_allowed_stays) {
  const ClosedOnAxis closed = close_on_axis(curtain(), 1e-12);
  EXPECT_EQ(closed.voids, 0);
  EXPECT_TRUE(has_reached_axis(closed.mesh));
}

TEST(AxisClosing, a_body_that_ends_on_the_axis_has_not_reached_it) {
  EXPECT_FALSE(has_reached_axis(cylinder()));
}

}  // namespace
}  // namespace parison::remesh
