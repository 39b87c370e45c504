// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "../../structured.hpp"
#include "../scene_text.hpp"
#include "core/mesh/element.hpp"
#include "forming/report/contour/contour.hpp"
#include "forming/report/files/history.hpp"
#include "forming/report/files/result_files.hpp"
#include "forming/state/initial_state.hpp"

namespace parison::forming {
namespace {

/// A wall between r = 20 mm + 2 z^2 / 100 mm and 4 mm more, 50 mm high: its edges are exactly quadratic.
core::Mesh bent_wall() {
  return tests::structured(3, 10, [](double s, double t) {
    const double z = 0.05 * t;
    return Point(0.02 + 20 * z * z + 0.004 * s, z);
  });
}

/// Volume of that wall between two heights: pi (b^2 - a^2) with b = a + w is pi w (2 a + w).
double exact_volume(double from, double to) {
  const double w = 0.004;
  const auto below = [&](double z) { return M_PI * w * (2 * (0.02 * z + 20 * z * z * z / 3) + w * z); };
  return below(to) - below(from);
}

TEST(SectionSlice, the_volume_beyond_a_level_is_exact_for_quadratic_edges) {
  const core::Mesh mesh = bent_wall();
  const auto geometry = core::Geometry::axisymmetric;
  for (const double level : {0.0, 0.0003, 0.0125, 0.025, 0.0377, 0.05}) {
    EXPECT_NEAR(volume_beyond(mesh, geometry, level, 1), exact_volume(level, 0.05), 1e-17) << level;
    EXPECT_NEAR(volume_beyond(mesh, geometry, level, -1), exact_volume(0, level), 1e-17) << level;
  }
  EXPECT_NEAR(volume_beyond(mesh, geometry, -1, 1), core::volume(mesh, geometry), 1e-17);
  EXPECT_EQ(volume_beyond(mesh, geometry, 1, 1), 0);
  EXPECT_NEAR(volume_beyond(mesh, core::Geometry::planar, 0.0125, 1), 0.004 * 0.0375, 1e-16);
}

TEST(SectionSlice, the_volume_beyond_a_level_is_exact_where_an_edge_begins_on_it_bulges_beyond_and_comes_back) {
  const double r = 0.02, w = 0.004, h = 0.001, top = 0.05;
  const core::Mesh mesh = tests::structured(1, 10, [&](double s, double t) {
    return Point(r + w * s, (1 - t) * h * (2 * s * s - s) + t * top);  // nodes of the lowest edge at 0, 0 and h
  });
  const auto geometry = core::Geometry::axisymmetric;
  const double below = 2 * M_PI * h * w * (r / 24 + w / 96);
  EXPECT_NEAR(volume_beyond(mesh, geometry, 0, -1), below, 1e-17);
  EXPECT_NEAR(volume_beyond(mesh, geometry, 0, 1), core::volume(mesh, geometry) - below, 1e-17);
}

TEST(SectionSlice, a_level_crosses_the_outline_where_its_curves_are) {
  const auto crossings = outline_crossings(bent_wall(), 0.0377);
  ASSERT_EQ(crossings.size(), 2u);
  EXPECT_NEAR(crossings[0], 0.02 + 20 * 0.0377 * 0.0377, 1e-15);
  EXPECT_NEAR(crossings[1], crossings[0] + 0.004, 1e-15);
  EXPECT_TRUE(outline_crossings(bent_wall(), 0.06).empty());
  for (int i = 1; i < 1000; ++i) EXPECT_EQ(outline_crossings(bent_wall(), 0.05 * i / 1000).size(), 2u) << i;
}

/// A tube of 27 and 31 mm radius and 40 mm height.
std::string tube() {
  std::string text =
      replaced("{ name = \"surface\", path = \"(0, 0) (20, 0) (20, 10) (0, 10) mm\", condition = \"contact\" },",
               "{ name = \"end\", path = \"(27, 0) (31, 0) mm\", condition = \"contact\" },"
               "{ name = \"outer\", path = \"(31, 40) mm\", condition = \"contact\" },"
               "{ name = \"top\", path = \"(27, 40) mm\", condition = \"contact\" },");
  text = replaced("{ name = \"axis\", path = \"(0, 0) mm\", condition = \"symmetry\" },",
                  "{ name = \"inner\", path = \"(27, 0) mm\", condition = \"contact\" },", text);
  return replaced("pressure.surface", "pressure.inner", replaced("(0, 5) mm", "(29, 5) mm", text));
}

TEST(Contour, both_sides_of_a_tube_have_its_thickness) {
  const Scene scene = scene_of(tube());
  const State state = initial_state(scene);
  int outer = 0, inner = 0;
  for (const ContourPoint& point : contour(scene, state, thickness_profile(scene, state))) {
    const double z = point.position[1];
    EXPECT_EQ(point.loop, 0);
    EXPECT_NEAR(point.temperature, 1273.15, 1e-9);
    if (z < 1e-3 || z > 0.039) continue;
    EXPECT_NEAR(point.thickness, 4e-3, 1e-9);
    EXPECT_NEAR(point.position[0], point.side == remesh::SurfacePart::outer ? 0.031 : 0.027, 1e-9);
    (point.side == remesh::SurfacePart::outer ? outer : inner) += 1;
  }
  EXPECT_GT(outer, 20);
  EXPECT_GT(inner, 20);
}

TEST(Contour, the_weight_above_a_height_of_a_tube_falls_linearly_upwards_and_with_gravity_turned) {
  for (const bool turned : {false, true}) {
    Scene scene = scene_of(tube());
    for (Stage& stage : scene.stages) stage.gravity = turned ? 9.81 : -9.81;
    const State state = initial_state(scene);
    const double weight = 2400 * M_PI * (0.031 * 0.031 - 0.027 * 0.027) * 0.04;
    const auto rows = height_rows(scene, state, contour(scene, state, thickness_profile(scene, state)));
    ASSERT_EQ(rows.size(), 401u);
    for (const HeightRow& row : rows) {
      EXPECT_NEAR(row.weight_above, weight * (1 - row.height / 0.04), 1e-9 * weight);
      EXPECT_NEAR(row.axial, turned ? 0.04 - row.height : row.height, 1e-12);
      EXPECT_NEAR(row.outer_radius, 0.031, 1e-9);
      EXPECT_NEAR(row.inner_radius, 0.027, 1e-9);
      if (row.height < 1e-3 || row.height > 0.039) continue;
      EXPECT_NEAR(row.thickness, 4e-3, 1e-9);
    }
  }
}

TEST(Contour, above_height_0_is_all_of_the_glass_and_the_inner_radius_under_a_push_up_is_that_of_the_push_up) {
  const Scene scene = scene_of(
      replaced("path = \"(0, 0) mm\", condition = \"symmetry\"", "path = \"(0, 2) mm\", condition = \"symmetry\"",
               replaced("path = \"(0, 0) (20, 0) (20, 10)", "path = \"(0, 2) (10, 0) (20, 0) (20, 10)")));
  const State state = initial_state(scene);
  const auto rows = height_rows(scene, state, contour(scene, state, thickness_profile(scene, state)));
  const double weight = glass_facts(scene, state).mass;
  EXPECT_EQ(rows.front().weight_above, weight);
  for (const HeightRow& row : rows) {
    const double push_up = row.height < 2e-3 ? 5 * (2e-3 - row.height) : 0;
    EXPECT_NEAR(row.inner_radius, push_up, 1e-7) << row.height;
    EXPECT_NEAR(row.outer_radius, 0.02, 1e-7) << row.height;
  }
}

TEST(BodyFields, the_flux_of_a_linear_temperature_is_conductivity_times_gradient) {
  const core::Mesh mesh = bent_wall();
  thermal::Material material{2400, core::constant(1300), core::constant(1.3), std::nullopt};
  Eigen::VectorXd temperature(mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) temperature[n] = 1000 + 2e4 * mesh.nodes[n][0] - 3e3 * mesh.nodes[n][1];
  const Eigen::VectorXd wall = Eigen::VectorXd::Constant(mesh.node_count(), 4e-3);
  const Eigen::VectorXd flux = conducted_flux(mesh, core::Geometry::axisymmetric, material, temperature, wall);
  for (Index n = 0; n < mesh.node_count(); ++n) {
    EXPECT_NEAR(flux[2 * n], -1.3 * 2e4, 1e-5);
    EXPECT_NEAR(flux[2 * n + 1], 1.3 * 3e3, 1e-5);
  }
  material.radiation = thermal::Radiation{1.5, 150, true};
  const Eigen::VectorXd more = conducted_flux(mesh, core::Geometry::axisymmetric, material, temperature, wall);
  for (Index n = 0; n < mesh.node_count(); ++n)
    EXPECT_NEAR(more[2 * n] / flux[2 * n],
                1 + 16.0 / 3 * 1.5 * 1.5 * thermal::stefan_boltzmann * std::pow(temperature[n], 3) / 150 /
                        (1 + 4 / (3 * 150 * 4e-3)) / 1.3,
                1e-9);
}

}  // namespace
}  // namespace parison::forming
