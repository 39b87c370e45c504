// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../scene_text.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/state/initial_state.hpp"
#include "output_text.hpp"

namespace parison::forming {
namespace {

TEST(ThicknessProfile, a_shell_has_its_thickness_and_its_outer_area_everywhere) {
  const Scene scene = case_of("shell_inflation");
  const auto rows = thickness_profile(scene, initial_state(scene)).rows;
  double area = 0, arc = -1;
  for (const ThicknessRow& row : rows) {
    EXPECT_NEAR(row.position.norm(), 0.015, 1e-6);
    EXPECT_NEAR(row.thickness, 0.005, 5e-6);
    EXPECT_TRUE(row.is_wall());
    EXPECT_TRUE(std::isnan(row.inner_temperature));
    EXPECT_GT(row.arc, arc);
    arc = row.arc;
    area += row.area;
  }
  EXPECT_NEAR(arc, 0.5 * M_PI * 0.015, 1e-7);
  EXPECT_NEAR(area, 2 * M_PI * 0.015 * 0.015, 1e-8);
  const ThicknessRange range = thickness_range(rows);
  for (const double thickness : {range.lowest, range.mean, range.highest}) EXPECT_NEAR(thickness, 0.005, 5e-6);
}

TEST(ThicknessProfile, both_temperatures_of_a_linear_field_are_found) {
  const Scene scene = case_of("contact_cylinders");
  State state = initial_state(scene);
  GlassState& glass = state.glass;
  for (Index i = 0; i < glass.mesh.node_count(); ++i)
    glass.temperature[i] = 1300 + 5000 * glass.mesh.nodes[i][1] + 1000 * glass.mesh.nodes[i][0];
  int bottom = 0;
  for (const ThicknessRow& row : thickness_profile(scene, state).rows) {
    if (row.position[1] > 1e-9 || row.position[0] > 0.0199) continue;
    EXPECT_NEAR(row.thickness, 0.02, 1e-9);
    EXPECT_NEAR(row.outer_temperature, 1300 + 1000 * row.position[0], 1e-9);
    EXPECT_NEAR(row.inner_temperature, row.outer_temperature + 100, 1e-6);
    ++bottom;
  }
  EXPECT_GT(bottom, 20);
}

TEST(ThicknessProfile, only_rows_of_the_wall_count_and_the_extremes_have_places) {
  std::vector<ThicknessRow> rows(3);
  rows[0] = {0, {1, 2}, 2e-3, 0, 0, 1e-4, WallMark::wall, {0, 0}};
  rows[1] = {1, {3, 4}, 4e-3, 0, 0, 3e-4, WallMark::wall, {0, 0}};
  rows[2] = {2, {5, 6}, 9e-3, 0, 0, 9e-4, WallMark::rim, {0, 0}};
  const ThicknessRange range = thickness_range(rows);
  EXPECT_EQ(range.lowest, 2e-3);
  EXPECT_EQ(range.highest, 4e-3);
  EXPECT_EQ(range.lowest_at, Point(1, 2));
  EXPECT_EQ(range.highest_at, Point(3, 4));
  EXPECT_NEAR(range.mean, 3.5e-3, 1e-15);
}

/// Glass of revolution at rest, with edges of that length and that outline.
Scene resting_glass(const std::string& edge, const std::string& boundary) {
  return scene_of(R"(case = "outline"
geometry = "axisymmetric"
[material.liquid]
density = "2400 kg/m3"
viscosity = { law = "constant", value = "1e4 Pa.s" }
[glass]
material = "liquid"
mesh = { size = ")" +
                  edge + R"(", contact_size = ")" + edge + "\" }\nboundary = [" + boundary + R"(]
[[stage]]
name = "rest"
duration = "1 s"
gravity = "-9.81 m/s2"
)");
}

/// The height up to which a solid of revolution is wall by its area, mm: from 20 mm radius inwards to a cylinder of 18
/// mm up to the height of 10 mm, then to an arc that turns away from there.
double wall_height(const std::string& edge) {
  const Scene scene = resting_glass(edge, R"(
  { name = "bottom", condition = "symmetry", path = "(18, 0) (20, 0) mm" },
  { name = "outer", condition = "contact", path = "(20, 30) mm" },
  { name = "top", condition = "fixed", path = "(8, 30) mm" },
  { name = "inner", condition = "contact", path = [
    "(8, 20) mm", "arc centre (8, 10) mm radius 10 mm from 90 deg to 0 deg", "(18, 0) mm"] })");
  double area = 0;
  for (const ThicknessRow& row : thickness_profile(initial_state(scene).glass.mesh, scene.geometry).rows)
    if (row.is_wall()) area += row.area;
  return 1e6 * area / (2 * M_PI * 20);
}

TEST(ThicknessProfile, the_wall_ends_where_its_sides_face_away_whatever_the_mesh) {
  // The sides make an angle of cosine 0.8 there, 6 mm up the arc.
  for (const char* edge : {"1.6 mm", "1.5 mm", "1.3 mm", "1.1 mm"}) EXPECT_NEAR(wall_height(edge), 16, 0.05) << edge;
}

/// Mean thickness, mm, of a wall whose outer side turns by 45 degrees at a corner, from a cone to a cylinder; the inner
/// side is round there, so that rays within 0.3 mm of the corner meet it less squarely than a wall's do.
double mean_of_turning_wall(const std::string& edge) {
  const Scene scene = resting_glass(edge, R"(
  { name = "rim", condition = "fixed", path = "(10.5857864, 1.4142136) (12, 0) mm" },
  { name = "outer", condition = "contact", path = "(20, 8) (20, 30) mm" },
  { name = "top", condition = "symmetry", path = "(18, 30) mm" },
  { name = "inner", condition = "contact", path = [
    "(18, 10.0710678) mm", "arc centre (15, 10.0710678) mm radius 3 mm from 0 deg to -45 deg",
    "(10.5857864, 1.4142136) mm"] })");
  return 1e3 * thickness_range(thickness_profile(initial_state(scene).glass.mesh, scene.geometry).rows).mean;
}

TEST(ThicknessProfile, the_mean_counts_a_corner_of_the_wall_whatever_the_mesh) {
  const double fine = mean_of_turning_wall("0.1 mm");
  for (const char* edge : {"0.8 mm", "0.6 mm", "0.5 mm", "0.4 mm", "0.3 mm", "0.2 mm"})
    EXPECT_NEAR(mean_of_turning_wall(edge), fine, 2e-3 * fine) << edge;
}

TEST(ThicknessProfile, an_end_face_looks_along_the_wall_and_does_not_count) {
  std::string text =
      replaced("{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\", condition = \"contact\" },",
               "{ name = \"end\", path = \"(27, 0) (31, 0) mm\", condition = \"contact\" },"
               "{ name = \"outer\", path = \"(31, 40) mm\", condition = \"contact\" },"
               "{ name = \"top\", path = \"(27, 40) mm\", condition = \"contact\" },");
  text = replaced("{ name = \"axis\", path = \"(0, 0) mm\", condition = \"symmetry\" },",
                  "{ name = \"inner\", path = \"(27, 0) mm\", condition = \"contact\" },", text);
  text = replaced("pressure.surface", "pressure.inner", replaced("(0, 5) mm", "(29, 5) mm", text));
  const Scene scene = scene_of(text);
  int walls = 0, ends = 0;
  const auto rows = thickness_profile(scene, initial_state(scene)).rows;
  for (const ThicknessRow& row : rows) {
    const bool on_side = row.position[0] > 0.031 - 1e-9 && row.position[1] > 1e-3 && row.position[1] < 0.039;
    const bool on_end = row.position[0] < 0.0309 && row.position[1] < 1e-9;
    EXPECT_TRUE(!on_side || row.is_wall());
    EXPECT_FALSE(on_end && row.is_wall());
    walls += on_side;
    ends += on_end;
  }
  EXPECT_GT(walls, 20);
  EXPECT_GT(ends, 4);
  const ThicknessRange range = thickness_range(rows);
  EXPECT_NEAR(range.mean, 4e-3, 1e-9);
  EXPECT_NEAR(range.highest, 4e-3, 1e-9);
}

}  // namespace
}  // namespace parison::forming
