// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../scene_text.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/state/initial_state.hpp"
#include "structured.hpp"

namespace parison::forming {
namespace {

using core::Geometry;

/// The mesh of a section; `boundaries` are entries of the case file's list.
core::Mesh section(const std::string& geometry, const std::string& boundaries, const std::string& size = "1 mm") {
  return initial_state(scene_of("case = \"section\"\ngeometry = \"" + geometry + R"("
stage = [{ name = "rest", duration = "1 s" }]
[material.glass]
density = "2400 kg/m3"
heat_capacity = "1300 J/kg/K"
conductivity = "1.3 W/m/K"
[glass]
material = "glass"
temperature = "1000 degC"
mesh.size = ")" + size + R"("
boundary = [)" + boundaries + "]\n"))
      .glass.mesh;
}

std::string boundary(const std::string& name, const std::string& path, const std::string& condition = "insulated") {
  return "{ name = \"" + name + "\", condition = \"" + condition + "\", path = [" + path + "] },\n";
}

ThicknessProfile profile_of(const std::string& geometry, const std::string& boundaries) {
  return thickness_profile(section(geometry, boundaries),
                           geometry == "planar" ? Geometry::planar : Geometry::axisymmetric);
}

int count_of(const ThicknessProfile& profile, WallMark mark) {
  return static_cast<int>(
      std::count_if(profile.rows.begin(), profile.rows.end(), [&](const auto& row) { return row.mark == mark; }));
}

/// A wall of one thickness all over.
void expect_uniform(const ThicknessProfile& profile, double thickness, double tolerance) {
  EXPECT_EQ(profile.no_wall, "");
  EXPECT_GT(count_of(profile, WallMark::wall), 20);
  const ThicknessRange range = thickness_range(profile.rows);
  for (const double found : {range.lowest, range.mean, range.highest}) EXPECT_NEAR(found, thickness, tolerance);
}

void expect_no_wall(const ThicknessProfile& profile, const std::string& sentence) {
  EXPECT_EQ(profile.no_wall.rfind(sentence, 0), 0u) << profile.no_wall;
  EXPECT_EQ(count_of(profile, WallMark::none), static_cast<int>(profile.rows.size()));
  EXPECT_GT(profile.rows.size(), 20u);
  const ThicknessRange range = thickness_range(profile.rows);
  for (const double found : {range.lowest, range.mean, range.highest}) EXPECT_TRUE(std::isnan(found));
}

TEST(WallSides, a_disc_is_as_thick_as_it_is_with_its_side_as_rim_and_its_upper_face_as_inner_side) {
  const auto disc = profile_of("axisymmetric", boundary("all", "\"(0, 0) (30, 0) (30, 6) (0, 6) mm\"") +
                                                   boundary("axis", "\"(0, 0) mm\"", "symmetry"));
  expect_uniform(disc, 6e-3, 1e-12);
  for (const ThicknessRow& row : disc.rows) {
    const bool on_side = row.position[0] > 0.03 - 1e-9;
    EXPECT_EQ(row.mark, on_side ? WallMark::rim : WallMark::wall) << row.position.transpose();
    EXPECT_EQ(std::isnan(row.thickness), on_side);
    if (on_side) continue;
    EXPECT_NEAR(row.position[1], 0, 1e-12);
    EXPECT_NEAR((row.inner_position - Point(row.position[0], 6e-3)).norm(), 0, 1e-12);
  }
}

TEST(WallSides, a_cup_has_the_thickness_of_its_side_and_its_bottom_whichever_way_up) {
  for (const bool upright : {true, false}) {
    const std::string axis = boundary("axis", upright ? "\"(0, 0) mm\"" : "\"(0, 37) mm\"", "symmetry");
    const auto cup = profile_of("axisymmetric",
                                boundary("all", upright ? "\"(0, 0) (20, 0) (20, 40) (18, 40) (18, 3) (0, 3) mm\""
                                                        : "\"(0, 37) (18, 37) (18, 0) (20, 0) (20, 40) (0, 40) mm\"") +
                                    axis);
    EXPECT_EQ(cup.no_wall, "");
    int bottom = 0, side = 0;
    for (const ThicknessRow& row : cup.rows) {
      const double z = upright ? row.position[1] : 0.04 - row.position[1], r = row.position[0];
      if (z < 1e-9 && r < 0.018 - 1e-9) {
        EXPECT_NEAR(row.thickness, 3e-3, 1e-12);
        ++bottom;
      }
      if (r > 0.02 - 1e-9 && z > 3e-3 + 1e-9 && z < 0.04 - 1e-9) {
        EXPECT_NEAR(row.thickness, 2e-3, 1e-12);
        ++side;
      }
      if (z > 0.04 - 1e-9) EXPECT_EQ(row.mark, WallMark::rim);
      // The heel: nothing of the inside is opposite.
      if ((z < 1e-9 && r > 0.018 + 1e-9) || (r > 0.02 - 1e-9 && z < 3e-3 - 1e-9)) EXPECT_EQ(row.mark, WallMark::foot);
    }
    EXPECT_GT(bottom, 20);
    EXPECT_GT(side, 40);
  }
}

TEST(WallSides, a_capped_tube_has_its_wall_up_to_a_fixed_rim) {
  const auto tube = profile_of("axisymmetric", boundary("rim", "\"(9.2, 0) (10, 0) mm\"", "fixed") +
                                                   boundary("outer", "\"(10, 75) (0, 75) mm\"") +
                                                   boundary("axis", "\"(0, 74.2) mm\"", "symmetry") +
                                                   boundary("inner", "\"(9.2, 74.2) (9.2, 0) mm\""));
  expect_uniform(tube, 0.8e-3, 1e-12);
  for (const ThicknessRow& row : tube.rows)
    EXPECT_EQ(row.mark == WallMark::rim, row.position[1] < 1e-9) << row.position.transpose();
}

TEST(WallSides, a_fixed_rim_under_a_slanting_wall_is_no_thin_wall) {
  const auto tube = profile_of("axisymmetric", boundary("rim", "\"(8, 0) (12, 0) mm\"", "fixed") +
                                                   boundary("outer", "\"(20, 12) (20, 40) (0, 40) mm\"") +
                                                   boundary("axis", "\"(0, 38) mm\"", "symmetry") +
                                                   boundary("inner", "\"(18, 38) (18, 13) (8, 0) mm\""));
  EXPECT_EQ(tube.no_wall, "");
  EXPECT_NEAR(thickness_range(tube.rows).lowest, 2e-3, 1e-9);
  for (const ThicknessRow& row : tube.rows)
    if (row.position[1] < 1e-9 && row.position[0] < 12e-3 - 1e-9) EXPECT_EQ(row.mark, WallMark::rim);
}

TEST(WallSides, a_plate_held_on_its_under_side_has_its_thickness) {
  expect_uniform(profile_of("planar", boundary("held", "\"(0, 0) (40, 0) mm\"", "fixed") +
                                          boundary("free", "\"(40, 4) (0, 4) (0, 0) mm\"")),
                 4e-3, 1e-12);
}

TEST(WallSides, half_a_spherical_shell_ends_at_its_rim) {
  const auto shell =
      profile_of("axisymmetric",
                 boundary("inner", "\"arc centre (0, 0) mm radius 18 mm from 90 deg to 0 deg\"") +
                     boundary("outer", "\"(20, 0) mm\", \"arc centre (0, 0) mm radius 20 mm from 0 deg to 90 deg\"") +
                     boundary("axis", "\"(0, 18) mm\"", "symmetry"));
  expect_uniform(shell, 2e-3, 1e-6);
  for (const ThicknessRow& row : shell.rows) {
    EXPECT_EQ(row.mark == WallMark::rim, row.position[1] < 1e-9) << row.position.transpose();
    if (row.mark == WallMark::wall) EXPECT_NEAR(row.position.norm(), 0.02, 1e-6);
  }
}

TEST(WallSides, a_closed_shell_between_two_parts_of_the_axis_has_no_rim) {
  const auto shell =
      profile_of("axisymmetric", boundary("outer", "\"arc centre (0, 0) mm radius 20 mm from -90 deg to 90 deg\"") +
                                     boundary("above", "\"(0, 18) mm\"", "symmetry") +
                                     boundary("inner", "\"arc centre (0, 0) mm radius 18 mm from 90 deg to -90 deg\"") +
                                     boundary("below", "\"(0, -20) mm\"", "symmetry"));
  expect_uniform(shell, 2e-3, 1e-6);
  EXPECT_EQ(count_of(shell, WallMark::wall), static_cast<int>(shell.rows.size()));
  for (const ThicknessRow& row : shell.rows) EXPECT_NEAR(row.position.norm(), 0.02, 1e-6);
}

TEST(WallSides, a_tube_open_at_both_ends_has_two_rims_and_its_outside_outside) {
  const auto tube =
      profile_of("axisymmetric", boundary("all", "\"(18, 30) (18, 0) (20, 0) (20, 60) (18, 60) (18, 30) mm\""));
  expect_uniform(tube, 2e-3, 1e-12);
  for (const ThicknessRow& row : tube.rows) {
    const bool on_end = row.position[1] < 1e-9 || row.position[1] > 0.06 - 1e-9;
    EXPECT_EQ(row.mark, on_end ? WallMark::rim : WallMark::wall) << row.position.transpose();
    if (!on_end) EXPECT_NEAR(row.position[0], 0.02, 1e-12);
  }
  EXPECT_NEAR(tube.rows.back().arc, 0.064, 1e-9);
}

/// Rings of quadratic edges around the origin between two radii, m.
core::Mesh ring(double inner, double outer, Index count) {
  std::vector<Point> vertices;
  std::vector<std::array<Index, 3>> cells;
  for (const double radius : {inner, outer})
    for (Index i = 0; i < count; ++i)
      vertices.emplace_back(radius * std::cos(2 * M_PI * i / count), radius * std::sin(2 * M_PI * i / count));
  for (Index i = 0; i < count; ++i) {
    const Index next = (i + 1) % count;
    cells.push_back({i, count + i, count + next});
    cells.push_back({i, count + next, next});
  }
  core::Mesh mesh = core::make_quadratic_mesh(vertices, cells);
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    Point& mid = mesh.nodes[edge.nodes[2]];
    mid *= mesh.nodes[edge.nodes[0]].norm() / mid.norm();
  }
  return mesh;
}

TEST(WallSides, a_planar_ring_has_two_loops_as_sides) {
  const auto pipe = thickness_profile(ring(0.045, 0.05, 90), Geometry::planar);
  expect_uniform(pipe, 5e-3, 1e-6);
  for (const ThicknessRow& row : pipe.rows) EXPECT_NEAR(row.position.norm(), 0.05, 1e-6);
}

/// A quarter of a pipe between radii of 45 and 50 mm.
core::Mesh quarter_pipe() {
  return tests::structured(4, 40, [](double u, double v) {
    const double radius = 0.045 + 0.005 * u, angle = 0.5 * M_PI * v;
    return Point(radius * std::cos(angle), radius * std::sin(angle));
  });
}

TEST(WallSides, a_section_of_a_pipe_ends_on_rims_or_on_symmetry_planes) {
  core::Mesh mesh = quarter_pipe();
  const auto cut = thickness_profile(mesh, Geometry::planar);
  expect_uniform(cut, 5e-3, 1e-6);
  EXPECT_GT(count_of(cut, WallMark::rim), 15);
  for (const char* end : {"bottom", "top"})
    mesh.edit().boundaries[core::find_boundary(mesh, end)].kind = core::BoundaryKind::symmetry;
  const auto mirrored = thickness_profile(mesh, Geometry::planar);
  expect_uniform(mirrored, 5e-3, 1e-6);
  EXPECT_EQ(count_of(mirrored, WallMark::rim), 0);
  for (const ThicknessRow& row : mirrored.rows) EXPECT_NEAR(row.position.norm(), 0.05, 1e-6);
}

TEST(WallSides, half_a_plate_has_the_thickness_of_the_whole_one) {
  const auto plate = profile_of("planar", boundary("all", "\"(0, 0) (40, 0) (40, 2) (0, 2) mm\"") +
                                              boundary("left", "\"(0, 0) mm\"", "symmetry"));
  expect_uniform(plate, 2e-3, 1e-12);
  const auto half = profile_of("planar", boundary("middle", "\"(0, 0) (40, 0) mm\"", "symmetry") +
                                             boundary("all", "\"(40, 2) (0, 2) (0, 0) mm\""));
  expect_uniform(half, 4e-3, 1e-12);
  EXPECT_GT(count_of(half, WallMark::rim), 4);
}

TEST(WallSides, a_bottle_with_a_push_up_has_a_wall_up_to_the_axis_and_a_foot_where_it_stands) {
  // The bottom is a cone of 1 in 4, 3 mm thick across; a foot ring of 2 mm runs around it.
  const double lift = 3e-3 * std::sqrt(17.0) / 4;
  const auto bottle = profile_of(
      "axisymmetric", boundary("outer", "\"(0, 6) (16, 2) (16, 0) (18, 0) (20, 2) (20, 60) (8, 80) (8, 100) mm\"") +
                          boundary("rim", "\"(6, 100) mm\"") +
                          boundary("inner", fmt::format("\"(6, 79.4305) (18, 59.4305) (18, {0}) (0, {1}) mm\"",
                                                        1e3 * (6e-3 - 18e-3 / 4 + lift), 1e3 * (6e-3 + lift))) +
                          boundary("axis", "\"(0, 6) mm\"", "symmetry"));
  EXPECT_EQ(bottle.no_wall, "");
  int push_up = 0, foot = 0, body = 0;
  for (const ThicknessRow& row : bottle.rows) {
    const double r = row.position[0], z = row.position[1];
    if (r < 14e-3 && z < 7e-3) {
      EXPECT_EQ(row.mark, WallMark::wall) << row.position.transpose();
      // Nearer to the axis than the way runs sideways it ends on the far side of the cone.
      if (r > 3e-3 / std::sqrt(17.0) + 1e-4) EXPECT_NEAR(row.thickness, 3e-3, 1e-12);
      EXPECT_NEAR(row.thickness, 3e-3, 0.4e-3);
      ++push_up;
    }
    if (r > 16e-3 + 1e-9 && r < 18e-3 - 1e-9 && z < 1e-9) {
      EXPECT_EQ(row.mark, WallMark::foot);
      ++foot;
    }
    if (r > 20e-3 - 1e-9 && z > 8e-3 && z < 58e-3) {
      EXPECT_NEAR(row.thickness, 2e-3, 1e-12);
      ++body;
    }
    if (z > 0.1 - 1e-9) EXPECT_EQ(row.mark, WallMark::rim);
  }
  EXPECT_GT(push_up, 20);
  EXPECT_GT(foot, 1);
  EXPECT_GT(body, 50);
  EXPECT_NEAR(thickness_range(bottle.rows).lowest, 2e-3, 1e-9);
}

TEST(WallSides, a_rounded_rim_is_rim_from_where_its_sides_bend_away) {
  const auto cup = profile_of(
      "axisymmetric", boundary("outer", "\"(0, 0) (20, 0) (20, 40) mm\"") +
                          boundary("lip", "\"arc centre (18, 40) mm radius 2 mm from 0 deg to 180 deg\"") +
                          boundary("inner", "\"(16, 4) (0, 4) mm\"") + boundary("axis", "\"(0, 0) mm\"", "symmetry"));
  expect_uniform(cup, 4e-3, 0.05e-3);
  for (const ThicknessRow& row : cup.rows) {
    if (row.position[1] > 41e-3) EXPECT_EQ(row.mark, WallMark::rim);
    if (row.position[0] > 20e-3 - 1e-9 && row.position[1] > 5e-3) EXPECT_EQ(row.mark, WallMark::wall);
  }
}

TEST(WallSides, shares_of_the_arc_end_in_the_middle_of_a_rim_and_the_wall_beside_it_whatever_the_mesh) {
  const std::string parts = boundary("end", "\"(16, 0) (20, 0) mm\"") + boundary("outer", "\"(20, 40) mm\"") +
                            boundary("lip", "\"arc centre (18, 40) mm radius 2 mm from 0 deg to 180 deg\"") +
                            boundary("inner", "\"(16, 0) mm\"");
  for (const char* size : {"1.1 mm", "1 mm", "0.9 mm", "0.75 mm", "0.6 mm"}) {
    const ThicknessProfile tube = thickness_profile(section("axisymmetric", parts, size), Geometry::axisymmetric);
    EXPECT_NEAR(tube.last_arc - tube.first_arc, 2e-3 + 40e-3 + M_PI * 1e-3, 5e-6) << size;
    double area = 0;
    for (const ThicknessRow& row : tube.rows)
      if (row.is_wall()) area += row.area;
    // Rays that meet the inner side with a cosine of 0.97.
    const double turned = std::acos(0.97), lip = 2e-3 * (18e-3 * turned + 2e-3 * std::sin(turned));
    EXPECT_NEAR(area / (2 * M_PI), 20e-3 * 40e-3 + lip, 20e-3 * 0.05e-3) << size;
  }
}

TEST(WallSides, glass_that_swells_over_a_held_rim_does_not_move_its_middle) {
  const auto end_with = [](double swelling) {
    const std::string neck = fmt::format("\"(9, -2) (9.3, -0.5) (9.1, {0}) (9.04, {0}) (9, 0) mm\"", swelling);
    const ThicknessProfile tube = profile_of(
        "axisymmetric", boundary("end", "\"(6, -30) (9, -30) mm\"") + boundary("outer", neck) +
                            boundary("held", "\"(6, 0) mm\"", "fixed") + boundary("inner", "\"(6, -30) mm\""));
    return 1e3 * tube.last_arc - (1e3 * tube.rows.back().arc - 1.5);
  };
  EXPECT_NEAR(end_with(0.001), 0, 0.4);
  EXPECT_NEAR(end_with(0.06), end_with(0.001), 0.1);
}

TEST(WallSides, the_middle_of_a_held_rim_is_that_of_its_boundary_however_steeply_the_wall_leaves_it) {
  for (const double dip : {0.0, 1.0, 2.0, 2.6}) {
    const std::string inner =
        fmt::format("\"(31.2, {}) (29, {}) (25.2, 1) (21.8, -16) (0, -16) mm\"", 4 - dip, 3.6 - dip);
    const ThicknessProfile cup =
        profile_of("axisymmetric", boundary("outer", "\"(0, -20) (24, -20) (28, 0) (32, 0) mm\"") +
                                       boundary("rim", "\"(32, 4) mm\"", "fixed") + boundary("inner", inner) +
                                       boundary("axis", "\"(0, -20) mm\"", "symmetry"));
    ASSERT_EQ(cup.no_wall, "") << dip;
    EXPECT_NEAR(cup.last_arc, 24e-3 + std::hypot(4e-3, 20e-3) + 6e-3, 1e-8) << dip;
  }
}

TEST(WallSides, a_heavy_dish_has_a_bottom_and_a_flange_ends_in_a_rim) {
  const auto dish =
      profile_of("axisymmetric", boundary("all", "\"(0, 0) (60, 0) (60, 30) (45, 30) (40, 12) (0, 12) mm\"") +
                                     boundary("axis", "\"(0, 0) mm\"", "symmetry"));
  expect_uniform(dish, 12e-3, 1e-12);
  const auto pot = profile_of(
      "axisymmetric", boundary("all", "\"(0, 0) (20, 0) (20, 50) (30, 50) (30, 52) (18, 52) (18, 2) (0, 2) mm\"") +
                          boundary("axis", "\"(0, 0) mm\"", "symmetry"));
  expect_uniform(pot, 2e-3, 1e-12);
  for (const ThicknessRow& row : pot.rows)
    if (row.position[0] > 30e-3 - 1e-9) EXPECT_EQ(row.mark, WallMark::rim);
}

TEST(WallSides, a_thick_roll_at_the_rim_of_a_thin_dish_is_no_wall) {
  const auto dish =
      profile_of("axisymmetric", boundary("outer", "\"(0, 0) (28, 0) (28, 11) mm\"") +
                                     boundary("roll", "\"arc centre (24, 11) mm radius 4 mm from 0 deg to 180 deg\"") +
                                     boundary("inner", "\"(20, 1.5) (0, 1.5) mm\"") +
                                     boundary("axis", "\"(0, 0) mm\"", "symmetry"));
  expect_uniform(dish, 1.5e-3, 1e-9);
  for (const ThicknessRow& row : dish.rows)
    EXPECT_EQ(row.is_wall(), row.position[0] <= 20e-3) << row.position.transpose();
}

TEST(WallSides, a_gob_is_no_wall) {
  expect_no_wall(
      profile_of("axisymmetric", boundary("all", "\"arc centre (0, 0) mm radius 26 mm from -90 deg to 90 deg\"") +
                                     boundary("axis", "\"(0, -26) mm\"", "symmetry")),
      "the glass is no wall: ");
  expect_no_wall(
      profile_of("axisymmetric", boundary("all",
                                          "\"arc centre (0, 0) mm radius 14 mm from -90 deg to 0 deg\", \"arc centre "
                                          "(0, 66) mm radius 14 mm from 0 deg to 90 deg\"") +
                                     boundary("axis", "\"(0, -14) mm\"", "symmetry")),
      "the glass is no wall: nowhere do two sides of it face each other");
  expect_no_wall(
      profile_of("planar", boundary("above", "\"arc centre (0, 0) mm radius 10 mm from 0 deg to 180 deg\"") +
                               boundary("below", "\"arc centre (0, 0) mm radius 10 mm from 180 deg to 360 deg\"")),
      "the glass is no wall: nowhere do two sides of it face each other");
}

TEST(WallSides, a_rod_and_a_block_are_no_walls) {
  expect_no_wall(profile_of("axisymmetric", boundary("all", "\"(0, 0) (5, 0) (5, 60) (0, 60) mm\"") +
                                                boundary("axis", "\"(0, 0) mm\"", "symmetry")),
                 "the glass is no wall: nowhere do two sides of it face each other");
  expect_no_wall(profile_of("axisymmetric", boundary("all", "\"(0, 0) (10, 0) (10, 18) (0, 18) mm\"") +
                                                boundary("axis", "\"(0, 0) mm\"", "symmetry")),
                 "the glass is no wall: 18 mm thick and 19 mm long");
}

}  // namespace
}  // namespace parison::forming
