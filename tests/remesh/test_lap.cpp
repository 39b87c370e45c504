// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

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

/// Areas of the loops of a surface with straight edges, positive around glass, negative around air.
std::vector<double> loop_areas(const Surface& surface) {
  std::vector<double> areas;
  for (std::size_t k = 0; k + 1 < surface.outline.loop_start.size(); ++k)
    areas.push_back(loop_volume(surface.outline, surface.outline.loop_start[k], core::Geometry::planar));
  return areas;
}

/// A block of 10 by 10 with a slot, open at the right, whose upper lip dips by `dip` into the lower one.
Surface lipped_block(double dip, Index first = 0) {
  std::vector<Point> points{{0, 0},   {10, 0},  {10, 3},  {8, 3},   {6, 3},   {4, 3},   {2, 3},         {2, 7},
                            {4, 7},   {6, 7},   {8, 7},   {8.1, 6}, {8.2, 5}, {8.3, 4}, {8.5, 3 - dip}, {9.5, 3 - dip},
                            {9.7, 4}, {9.8, 5}, {9.9, 6}, {10, 7},  {10, 10}, {0, 10}};
  std::rotate(points.begin(), points.begin() + first, points.end());
  return polygon(points);
}

TEST(Crossings, glass_that_meets_glass_around_much_air_joins_and_the_air_gets_a_loop) {
  for (Index first = 0; first < 22; ++first) {
    Surface surface = lipped_block(0.1, first);
    const Crossings found = remove_crossings(core::Geometry::planar, {0.5, 1}, surface);
    EXPECT_EQ(found.first, -1) << first;
    EXPECT_EQ(found.enclosed, 1) << first;
    EXPECT_EQ(found.torn, 0) << first;
    const std::vector<double> areas = loop_areas(surface);
    ASSERT_EQ(areas.size(), 2u) << first;
    EXPECT_NEAR(areas[0], 100, 3) << first;
    EXPECT_LT(areas[1], -20) << first;
    EXPECT_NEAR(found.enclosed_volume, -areas[1], 2) << first;
    if (first < 3 || first > 16)  // else that vertex is at the air or gone
      EXPECT_EQ(surface.outline.vertices.front(), lipped_block(0.1, first).outline.vertices.front()) << first;
  }
}

/// A surface with one loop more.
Surface with_loop(Surface surface, const Surface& loop, double scale) {
  for (Index i = 0; i < loop.outline.edge_count(); ++i) {
    surface.outline.vertices.push_back(scale * loop.outline.vertices[i]);
    surface.outline.mids.push_back(scale * loop.outline.mids[i]);
    surface.outline.boundary_ids.push_back(0);
  }
  surface.outline.loop_start.push_back(surface.outline.edge_count());
  for (std::vector<bool>* flags : {&surface.contact, &surface.fixed})
    flags->assign(2 * surface.outline.vertices.size(), false);
  return surface;
}

TEST(Crossings, a_bubble_whose_sides_meet_is_filled_when_it_is_small_and_divided_when_it_is_large) {
  const auto with_bubble = [](double scale) {
    Surface surface = polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}});
    const Surface bubble = polygon({{2, 4},
                                    {2, 5},
                                    {2, 6},
                                    {4, 5.6},
                                    {5, 4.9},
                                    {6, 5.6},
                                    {8, 6},
                                    {8, 5},
                                    {8, 4},
                                    {6, 4.4},
                                    {5, 5.1},
                                    {4, 4.4}});  // pinched in the middle
    return with_loop(surface, bubble, scale);
  };
  Surface small = with_bubble(0.1), large = with_bubble(1);
  EXPECT_EQ(remove_crossings(core::Geometry::planar, {0.5, 1}, small).laps, 1);
  EXPECT_EQ(loop_areas(small).size(), 1u);
  const Crossings found = remove_crossings(core::Geometry::planar, {0.5, 1}, large);
  EXPECT_EQ(found.first, -1);
  EXPECT_EQ(found.enclosed, 0) << "it was enclosed before";
  EXPECT_EQ(find_crossing(large.outline).first, -1);
}

TEST(Crossings, a_bubble_that_breaks_through_the_surface_opens) {
  const Surface block = polygon({{0, 0}, {10, 0}, {10, 4}, {10, 4.7}, {10, 5.3}, {10, 6}, {10, 10}, {0, 10}});
  Surface surface = with_loop(block, polygon({{9, 4}, {9, 6}, {9.8, 5.4}, {10.1, 5}, {9.8, 4.6}}), 1);
  const Crossings found = remove_crossings(core::Geometry::planar, {0.1, 1}, surface);
  EXPECT_EQ(found.first, -1);
  ASSERT_EQ(loop_areas(surface).size(), 1u);
  EXPECT_NEAR(loop_areas(surface)[0], 98.7, 0.3);
}

TEST(Crossings, a_lap_over_the_begin_of_a_loop_is_cut_off_like_any_other) {
  for (Index first = 0; first < 9; ++first) {
    std::vector<Point> points{{0, 0},   {10, 0},    {10, 10},   {5.1, 10}, {4.9, 9.7},
                              {5, 9.4}, {5.2, 9.7}, {4.95, 10}, {0, 10}};
    std::rotate(points.begin(), points.begin() + first, points.end());
    Surface surface = polygon(points);
    const Crossings found = remove_crossings(core::Geometry::planar, {0.5, 5}, surface);
    EXPECT_EQ(found.first, -1) << first;
    EXPECT_GE(found.laps, 1) << first;
    EXPECT_NEAR(area(surface), 100, 0.5) << first;
  }
}

TEST(Crossings, the_volume_that_glass_fills_twice_is_measured) {
  const auto overlap = [](double shift) {
    core::Mesh mesh = slotted_plate();
    for (Point& x : mesh.nodes)
      if (x[1] > 5e-3 && x[0] > 10e-3) x[1] -= shift * (x[0] - 10e-3) / 20e-3;
    return overlap_volume(core::Geometry::planar, mesh);
  };
  EXPECT_EQ(overlap(0), 0);
  EXPECT_EQ(overlap(1.99e-3), 0);
  // The upper side is 1 mm too deep at its end: a triangle from the middle of the slot on.
  EXPECT_NEAR(overlap(3e-3), 0.5 * 1e-3 * 20e-3 / 3, 0.02 * 0.5 * 1e-3 * 20e-3 / 3);
}

/// A star with random waves and kinks, most of which cross themselves in several places.
Surface random_star(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0, 1);
  const int count = 8 + int(60 * uniform(random)), waves = 1 + int(5 * uniform(random));
  const double rough = 1.2 * uniform(random), phase = 2 * M_PI * uniform(random);
  std::vector<Point> points;
  for (int i = 0; i < count; ++i) {
    const double at = 2 * M_PI * i / count;
    const double angle = at + rough * (0.6 * std::sin(waves * at + phase) + 0.3 * (uniform(random) - 0.5));
    const double radius = 3 * (1 + rough * (0.8 * (uniform(random) - 0.5) + 0.5 * std::cos(2 * waves * at)));
    points.emplace_back(10 + radius * std::cos(angle), radius * std::sin(angle));
  }
  Surface surface = polygon(points);
  for (int i = 0; i < count; ++i) {
    surface.outline.boundary_ids[i] = 2 * i < count;
    surface.fixed[count + i] = uniform(random) < 0.02;
  }
  return surface;
}

TEST(Crossings, random_surfaces_are_left_whole_without_a_crossing_or_with_the_one_that_is_told) {
  std::mt19937 random(1);
  int mended = 0, enclosed = 0;
  for (int i = 0; i < 3000; ++i) {
    Surface surface = random_star(random);
    const auto geometry = i % 2 ? core::Geometry::planar : core::Geometry::axisymmetric;
    const Crossings found = remove_crossings(geometry, {1, 2, i % 5 ? 0 : 0.01}, surface);
    const Outline& outline = surface.outline;
    const std::size_t count = outline.vertices.size();
    ASSERT_EQ(outline.mids.size(), count) << i;
    ASSERT_EQ(outline.boundary_ids.size(), count) << i;
    ASSERT_EQ(surface.contact.size(), 2 * count) << i;
    ASSERT_EQ(surface.fixed.size(), 2 * count) << i;
    ASSERT_EQ(outline.loop_start.back(), static_cast<Index>(count)) << i;
    ASSERT_EQ(find_crossing(outline).first >= 0, found.first >= 0) << i;
    for (std::size_t k = 0; k + 1 < outline.loop_start.size() && found.first < 0; ++k)
      ASSERT_GE(outline.loop_start[k + 1] - outline.loop_start[k], min_edges) << i;
    mended += found.first < 0 && found.laps + found.torn + found.enclosed > 0;
    enclosed += found.enclosed;
  }
  EXPECT_GT(mended, 300);
  EXPECT_GT(enclosed, 30);
}

}  // namespace
}  // namespace parison::remesh
