// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/profiles.hpp"
#include "remesh/surface/repair/lap.hpp"

namespace parison::remesh {
namespace {

using core::Index;
using core::Point;

/// A planar surface through the points, m, with straight edges.
Surface polygon(const std::vector<Point>& points) {
  Surface surface;
  const auto count = static_cast<Index>(points.size());
  for (Index i = 0; i < count; ++i) {
    surface.outline.vertices.push_back(points[i]);
    surface.outline.mids.push_back(0.5 * (points[i] + points[(i + 1) % count]));
    surface.outline.boundary_ids.push_back(0);
  }
  surface.outline.loop_start.push_back(count);
  surface.contact.assign(2 * points.size(), false);
  surface.fixed.assign(2 * points.size(), false);
  return surface;
}

double area(const Surface& surface) {
  double sum = 0;
  const auto& x = surface.outline.vertices;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Point &a = x[i], &b = x[(i + 1) % x.size()];
    sum += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return sum;
}

/// A square of 10 with a head of 1 by 2 above it, on a neck whose sides have crossed.
Surface pinched() {
  return polygon({{0, 0},
                  {10, 0},
                  {10, 10},
                  {5.2, 10},
                  {4.9, 11},
                  {5.5, 12},
                  {5.5, 14},
                  {4.5, 14},
                  {4.5, 12},
                  {5.1, 11},
                  {4.8, 10},
                  {0, 10}});
}

TEST(Crossings, a_piece_behind_a_neck_thinner_than_nothing_is_cut_off) {
  Surface surface = pinched();
  const Crossings found = remove_crossings(core::Geometry::planar, {0.1, 5}, surface);
  EXPECT_EQ(found.first, -1);
  EXPECT_EQ(found.laps, 0);
  EXPECT_EQ(found.torn, 1);
  EXPECT_GT(found.torn_volume, 2);
  EXPECT_LT(found.torn_volume, 3);
  EXPECT_NEAR(area(surface), 100, 1);
}

TEST(Crossings, a_piece_on_a_neck_thinner_than_the_limit_is_cut_off_and_a_wedge_or_a_film_on_a_tool_is_not) {
  const auto necked = [](double half) {
    return polygon({{0, 0},
                    {10, 0},
                    {10, 10},
                    {5 + half, 10.5},
                    {5 + half, 11.5},
                    {5.5, 12},
                    {5.5, 14},
                    {4.5, 14},
                    {4.5, 12},
                    {5 - half, 11.5},
                    {5 - half, 10.5},
                    {0, 10}});
  };
  const CrossingLimits limits{0.1, 5, 0.05};
  Surface thin = necked(0.02), thick = necked(0.03), held = necked(0.02), large = necked(0.02);
  EXPECT_EQ(remove_crossings(core::Geometry::planar, limits, thin).torn, 1);
  EXPECT_NEAR(area(thin), 101, 4);
  EXPECT_EQ(remove_crossings(core::Geometry::planar, limits, thick).torn, 0);
  held.contact.assign(held.contact.size(), true);
  EXPECT_EQ(remove_crossings(core::Geometry::planar, limits, held).torn, 0);
  EXPECT_EQ(remove_crossings(core::Geometry::planar, {0.1, 1, 0.05}, large).torn, 0);
  Surface wedge = polygon({{0, 0}, {10, 0}, {10, 5}, {5, 5.01}, {0.02, 5.02}, {0, 5.03}, {-0.02, 5.02}, {-5, 5.01}});
  EXPECT_EQ(remove_crossings(core::Geometry::planar, limits, wedge).torn, 0);
}

TEST(Crossings, a_large_piece_is_left_and_said_to_be_torn) {
  Surface surface = pinched();
  const Crossings found = remove_crossings(core::Geometry::planar, {0.1, 1}, surface);
  EXPECT_GE(found.first, 0);
  EXPECT_TRUE(found.left_torn);
  EXPECT_GT(found.left_volume, 2);
}

TEST(Crossings, glass_that_overlaps_itself_is_a_lap) {
  // Two arms over a square grow into each other by 0.2.
  Surface surface = polygon(
      {{0, 0}, {10, 0}, {10, 10}, {4.9, 12}, {4.9, 11}, {8, 9}, {8, 8}, {2, 8}, {2, 9}, {5.1, 11}, {5.1, 12}, {0, 10}});
  const double before = area(surface);
  Surface left = surface;
  const Crossings found = remove_crossings(core::Geometry::planar, {20, 0}, surface);
  EXPECT_EQ(found.torn, 0);
  EXPECT_GE(found.laps, 1);
  EXPECT_GT(area(surface), before) << "the air between the arms is filled";
  EXPECT_FALSE(remove_crossings(core::Geometry::planar, {0.1, 50}, left).left_torn);
}

/// A plate of 30 mm by 10 mm with a slot of 2 mm width, 20 mm long, open at the right.
core::Mesh slotted_plate() {
  const core::Profile profile = Pen(0, 0)
                                    .line(30, 0, "below")
                                    .line(30, 4, "right")
                                    .line(10, 4, "lower side")
                                    .line(10, 6, "end")
                                    .line(30, 6, "upper side")
                                    .line(30, 10, "right")
                                    .line(0, 10, "above")
                                    .line(0, 0, "left")
                                    .closed();
  return mesh_profile(profile, {1e-3, 1e-3, 0.3, std::vector<bool>(8, false)});
}

TEST(Crossings, glass_that_folds_onto_itself_is_noticed_when_its_sides_meet) {
  const auto sheared = [](double shift) {
    core::Mesh mesh = slotted_plate();
    for (Point& x : mesh.nodes)
      if (x[1] > 5e-3 && x[0] > 10e-3) x[1] -= shift * (x[0] - 10e-3) / 20e-3;
    return crosses_itself(mesh);
  };
  EXPECT_FALSE(sheared(0));
  EXPECT_FALSE(sheared(1.99e-3));
  EXPECT_TRUE(sheared(2.01e-3));
}

TEST(Crossings, a_symmetry_line_is_no_surface_to_fold_onto) {
  core::Mesh mesh = slotted_plate();
  for (auto& boundary : mesh.edit().boundaries)
    if (boundary.name == "upper side") boundary.kind = core::BoundaryKind::symmetry;
  for (Point& x : mesh.nodes)
    if (x[1] > 5e-3 && x[1] < 7e-3 && x[0] > 10e-3 && x[0] < 29e-3) x[1] -= 2.5e-3;
  EXPECT_FALSE(crosses_itself(mesh));
}

/// A block of 10 with a notch in its top. The mid point of the left wall swerves round the tip of a spike on the right
/// wall, which the straight line between the wall's ends would cut.
TEST(Crossings, edges_that_only_their_mid_points_keep_apart_are_cut_too) {
  Surface surface =
      polygon({{0, 0}, {10, 0}, {10, 10}, {5.2, 10}, {4.85, 9.55}, {5.2, 9.1}, {5, 9}, {4.95, 10}, {0, 10}});
  surface.outline.mids[6] = Point(4.75, 9.5);
  ASSERT_NE(find_crossing(surface.outline).first, -1);
  const Crossings found = remove_crossings(core::Geometry::planar, {0.5, 5}, surface);
  EXPECT_EQ(found.first, -1);
  EXPECT_EQ(found.laps, 1);
  EXPECT_NEAR(area(surface), 100, 0.5);
  EXPECT_EQ(find_crossing(surface.outline).first, -1);
}

}  // namespace
}  // namespace parison::remesh
