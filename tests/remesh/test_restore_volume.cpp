// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/tolerances.hpp"
#include "remesh/surface/repair/restore_volume.hpp"
#include "structured.hpp"

namespace parison::remesh {
namespace {

using core::Geometry;
using core::Mesh;
using core::Point;

constexpr double side = 0.01;

Mesh block() {
  return tests::structured(8, 8, [](double s, double t) { return Point(side * (1 + s), side * t); });
}

/// A block whose nodes with `in_contact` touch a tool.
MovableSurface surface_of(bool (*in_contact)(const Point&)) {
  return {[](const Mesh& mesh) { return surface_normals(mesh, std::vector<bool>(mesh.boundaries().size(), true)); },
          [=](const Mesh& mesh) {
            std::vector<bool> flags;
            for (const Point& x : mesh.nodes) flags.push_back(in_contact(x));
            return flags;
          },
          {},
          4e-15,
          3};
}

double largest_shift(const Mesh& before, const Mesh& after, bool (*which)(const Point&)) {
  double largest = 0;
  for (std::size_t n = 0; n < before.nodes.size(); ++n)
    if (which(before.nodes[n])) largest = std::max(largest, (after.nodes[n] - before.nodes[n]).norm());
  return largest;
}

bool at_bottom(const Point& x) {
  return x[1] < 1e-9;
}
bool everywhere(const Point&) {
  return true;
}
bool nowhere(const Point&) {
  return false;
}
bool below_top_corner(const Point& x) {
  return x[0] < 1.95 * side || x[1] < 0.95 * side;
}

TEST(RestoreVolume, surface_normals_are_unit_and_those_of_corners_the_mean_of_both_sides) {
  const Mesh mesh = block();
  const auto all = surface_normals(mesh, {true, true, true, true}),
             bottom = surface_normals(mesh, {true, false, false, false});
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    const Point& x = mesh.nodes[n];
    EXPECT_LT((bottom[n] - (at_bottom(x) ? Point(0, -1) : Point(0, 0))).norm(), 1e-12);
    if (at_bottom(x) && x[0] > 1.999 * side) EXPECT_LT((all[n] - Point(1, -1).normalized()).norm(), 1e-12);
  }
}

TEST(RestoreVolume, the_surface_off_the_tools_takes_the_whole_shift) {
  for (const auto geometry : {Geometry::planar, Geometry::axisymmetric})
    for (const double factor : {0.99, 1.0001, 1.03}) {
      const Mesh before = block();
      Mesh mesh = before;
      const double target = factor * core::volume(mesh, geometry);
      const double reached = restore_volume(surface_of(at_bottom), geometry, target, mesh);
      EXPECT_EQ(reached, core::volume(mesh, geometry));
      EXPECT_NEAR(reached, target, 4e-15 * target);
      EXPECT_EQ(largest_shift(before, mesh, at_bottom), 0);
      EXPECT_GT(largest_shift(before, mesh, everywhere), 0.2 * std::abs(factor - 1) * side);
    }
}

TEST(RestoreVolume, the_whole_surface_moves_where_all_of_it_touches_tools) {
  const Mesh before = block();
  Mesh mesh = before;
  const double target = 1.001 * core::volume(mesh, Geometry::planar);
  EXPECT_NEAR(restore_volume(surface_of(everywhere), Geometry::planar, target, mesh), target, 4e-15 * target);
  EXPECT_GT(largest_shift(before, mesh, at_bottom), 0);
}

TEST(RestoreVolume, the_whole_surface_moves_a_little_rather_than_a_small_free_part_far) {
  const Mesh before = block();
  Mesh mesh = before;
  const double target = (1 + 5e-5) * core::volume(mesh, Geometry::planar);
  EXPECT_NEAR(restore_volume(surface_of(below_top_corner), Geometry::planar, target, mesh), target, 4e-15 * target);
  EXPECT_GT(largest_shift(before, mesh, at_bottom), 0);
  EXPECT_LT(largest_shift(before, mesh, everywhere), core::tolerance::whole_shift * core::size(before));
}

TEST(RestoreVolume, projected_nodes_are_made_up_for_by_the_others) {
  const Mesh before = block();
  Mesh mesh = before;
  const double target = 1.002 * core::volume(mesh, Geometry::planar);
  MovableSurface surface = surface_of(nowhere);
  surface.project = [](Mesh& moved) {  // a wall right of the block
    for (Point& x : moved.nodes) x[0] = std::min(x[0], 2 * side);
  };
  surface.in_contact = [](const Mesh& moved) {
    std::vector<bool> flags;
    for (const Point& x : moved.nodes) flags.push_back(x[0] >= 2 * side);
    return flags;
  };
  EXPECT_NEAR(restore_volume(surface, Geometry::planar, target, mesh), target, 4e-15 * target);
  for (const Point& x : mesh.nodes) EXPECT_LE(x[0], 2 * side);
}

}  // namespace
}  // namespace parison::remesh
