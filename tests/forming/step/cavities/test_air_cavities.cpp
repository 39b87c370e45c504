// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "contact/tool_outlines.hpp"
#include "figure.hpp"
#include "forming/step/cavities/air_cavities.hpp"
#include "structured.hpp"

namespace parison::forming {
namespace {

using contact::testing::mm;
using contact::testing::Outline;
using contact::testing::Pen;
using core::Geometry;

constexpr double gap = 0.1e-3;

/// Glass between two radii and two heights, in mm, and tools around it.
struct Scenery {
  core::Mesh mesh;
  std::vector<Index> contact_tool;
  std::vector<Outline> tools;
  std::vector<double> offsets;

  Scenery(double r0, double r1, double z0, double z1)
      : mesh(tests::structured(8, 8, [=](double s, double t) { return mm(r0 + s * (r1 - r0), z0 + t * (z1 - z0)); })) {
    contact_tool.assign(mesh.nodes.size(), -1);
    if (r0 == 0) mesh.edit().boundaries[3].kind = core::BoundaryKind::symmetry;
  }
  void add(Outline tool, double offset = 0) {
    tools.push_back(std::move(tool));
    offsets.push_back(offset);
  }
  /// The nodes of a side touch a tool.
  void touch(Index side, Index tool) {
    for (const auto& edge : mesh.boundary_edges())
      if (edge.boundary_id == side)
        for (const Index node : edge.nodes) contact_tool[node] = tool;
  }
  std::vector<AirCavity> cavities(Geometry geometry = Geometry::axisymmetric) const {
    std::vector<OutlinedTool> placed;
    for (std::size_t i = 0; i < tools.size(); ++i)
      placed.push_back({Index(i), &tools[i].profile, tools[i].contact, {false, false}, offsets[i]});
    const auto outlines = tool_outlines(placed, geometry, 0.5e-3, 1e-6);
    return air_cavities({mesh, geometry, exposed_edges(mesh, contact_tool), contact_tool}, outlines,
                        Index(tools.size()), gap);
  }
};

/// A cup of radius 10 mm: floor at z = 0, wall up to `top` mm.
Outline cup(double top) {
  return Pen(mm(10, top))
      .contact(mm(10, 0))
      .contact(mm(0, 0))
      .free(mm(0, -5))
      .free(mm(15, -5))
      .free(mm(15, top))
      .close();
}

TEST(AirCavities, a_piston_of_glass_seals_a_cup) {
  Scenery scene(0, 10, 4, 12);
  scene.add(cup(20));
  scene.touch(1, 0);
  const auto found = scene.cavities();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].volume, M_PI * 100e-6 * 4e-3, 1e-15);
  EXPECT_NEAR(found[0].exposed_area, M_PI * 100e-6, 1e-15);
  EXPECT_NEAR(found[0].tool_area[0], -M_PI * 100e-6, 1e-15);  // the floor moves up, the cavity shrinks
  EXPECT_EQ(found[0].edges.size(), 8u);
}

TEST(AirCavities, without_contact_there_is_none) {
  Scenery scene(0, 9, 4, 12);
  scene.add(cup(20));
  EXPECT_TRUE(scene.cavities().empty());
}

/// The wall of the cup as a ring that stands on a plate or hangs above it by `lift` mm.
std::vector<AirCavity> ring_on_plate(double lift) {
  Scenery scene(0, 10, 4, 12);
  scene.add(Pen(mm(40, 0)).contact(mm(0, 0)).free(mm(0, -5)).free(mm(40, -5)).close());
  scene.add(Pen(mm(10, 0)).free(mm(15, 0)).free(mm(15, 20)).free(mm(10, 20)).contact(mm(10, 0)).close(), 1e-3 * lift);
  scene.touch(1, 1);
  return scene.cavities();
}

TEST(AirCavities, a_ring_on_a_plate_is_tight_up_to_the_gap_that_seals) {
  for (const double lift : {0.0, 0.05}) {
    const auto found = ring_on_plate(lift);
    ASSERT_EQ(found.size(), 1u) << lift;
    EXPECT_NEAR(found[0].volume, M_PI * 100e-6 * 4e-3, 1e-14);
    EXPECT_NEAR(found[0].tool_area[0], -M_PI * 100e-6, 1e-14);
    EXPECT_NEAR(found[0].tool_area[1], 0, 1e-14);
  }
  EXPECT_TRUE(ring_on_plate(0.2).empty());
}

TEST(AirCavities, a_plunger_through_the_floor_bounds_the_cavity) {
  Scenery scene(0, 10, 4, 12);
  scene.add(cup(20));
  scene.add(Pen(mm(3, -30)).contact(mm(3, 2)).contact(mm(0, 2)).free(mm(0, -30)).close(), 1e-3);  // its top at 3 mm
  scene.touch(1, 0);
  const auto found = scene.cavities();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].volume, M_PI * (100 * 4 - 9 * 3) * 1e-9, 1e-14);
  EXPECT_NEAR(found[0].tool_area[0], -M_PI * 91e-6, 1e-14);
  EXPECT_NEAR(found[0].tool_area[1], -M_PI * 9e-6, 1e-14);
}

TEST(AirCavities, two_arcs_of_glass_bound_one_cavity) {
  // A tube of glass between two plates, around an open inside and with a cylinder around it: two cavities; with the
  // tube lifted off the lower plate they are one.
  for (const bool lifted : {false, true}) {
    Scenery scene(6, 8, lifted ? 1 : 0, 10);
    scene.add(
        Pen(mm(10, 10)).contact(mm(10, 0)).contact(mm(0, 0)).free(mm(0, -5)).free(mm(15, -5)).free(mm(15, 10)).close());
    scene.add(Pen(mm(0, 10)).contact(mm(10, 10)).free(mm(15, 10)).free(mm(15, 15)).free(mm(0, 15)).close());
    if (!lifted) scene.touch(0, 0);
    scene.touch(2, 1);
    const auto found = scene.cavities();
    ASSERT_EQ(found.size(), lifted ? 1u : 2u);
    double sum = 0;
    for (const auto& cavity : found) sum += cavity.volume;
    EXPECT_NEAR(sum, M_PI * (1000 - 28 * (lifted ? 9 : 10)) * 1e-9, 1e-14);
  }
}

TEST(AirCavities, contact_that_opens_between_nodes_in_contact_is_a_cavity_of_its_own) {
  Scenery scene(0, 10, 0, 10);
  scene.add(cup(20));
  scene.touch(0, 0);
  scene.touch(1, 0);
  std::vector<Index> opened;
  for (const auto& edge : scene.mesh.boundary_edges())
    if (edge.boundary_id == 0 && edge.nodes[2] % 3 == 1) {
      scene.contact_tool[edge.nodes[2]] = -1;
      opened.push_back(edge.nodes[2]);
      break;
    }
  ASSERT_EQ(opened.size(), 1u);
  const auto flat = scene.cavities();
  ASSERT_EQ(flat.size(), 1u);
  EXPECT_NEAR(flat[0].volume, 0, 1e-18);
  scene.mesh.nodes[opened[0]][1] += 1e-5;
  EXPECT_GT(scene.cavities()[0].volume, 1e-11);
}

TEST(AirCavities, the_volume_changes_with_the_tool_as_its_area_says) {
  Scenery scene(0, 10, 4, 12);
  scene.add(cup(20));
  scene.add(Pen(mm(3, -30)).contact(mm(3, 0)).contact_arc(mm(0, 0), 3e-3, 0, M_PI / 2).free(mm(0, -30)).close());
  scene.touch(1, 0);
  scene.offsets[1] = 0.5e-3;
  const auto before = scene.cavities();
  scene.offsets[1] += 1e-5;
  const auto after = scene.cavities();
  ASSERT_EQ(before.size(), 1u);
  EXPECT_NEAR((after[0].volume - before[0].volume) / 1e-5, before[0].tool_area[1], 1e-9);
  EXPECT_NEAR(before[0].tool_area[1], -M_PI * 9e-6, 1e-9);
}

/// A quarter of a shell between the axis and the plane z = 0, in the hole of which nothing else is.
core::Mesh quarter_shell(double inner, double outer) {
  core::Mesh mesh = tests::structured(4, 8, [=](double s, double t) -> Point {
    const double radius = 1e-3 * (inner + s * (outer - inner)), angle = M_PI / 2 * t;
    return {t == 1 ? 0.0 : radius * std::cos(angle), t == 0 ? 0.0 : radius * std::sin(angle)};
  });
  for (const Index side : {0, 2}) mesh.edit().boundaries[side].kind = core::BoundaryKind::symmetry;
  return mesh;
}

TEST(AirCavities, the_corner_of_two_symmetry_lines_closes_a_cavity) {
  for (const Geometry geometry : {Geometry::axisymmetric, Geometry::planar}) {
    const core::Mesh mesh = quarter_shell(10, 12);
    const std::vector<Index> contact_tool(mesh.nodes.size(), -1);
    const auto found = air_cavities({mesh, geometry, exposed_edges(mesh, contact_tool), contact_tool}, {}, 0, gap);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_NEAR(found[0].volume / (geometry == Geometry::planar ? M_PI / 4 * 1e-4 : 2 * M_PI / 3 * 1e-6), 1, 2e-4);
    EXPECT_EQ(found[0].edges.size(), 8u);
  }
}

TEST(AirCavities, a_tool_at_a_plane_and_glass_at_the_axis_close_a_cavity_by_their_corner) {
  // A tube between planes of symmetry at z = 0 and at z = 20 mm, with a disc of glass in it.
  Scenery scene(0, 10, 4, 12);
  scene.add(Pen(mm(10, 20)).contact(mm(10, 0)).free(mm(15, 0)).free(mm(15, 20)).close());
  scene.touch(1, 0);
  const std::vector<OutlinedTool> placed{{0, &scene.tools[0].profile, {false, true}, {true, false}, 0}};
  const ExposedGlass glass{scene.mesh, Geometry::axisymmetric, exposed_edges(scene.mesh, scene.contact_tool),
                           scene.contact_tool};
  const auto found = air_cavities(glass, tool_outlines(placed, Geometry::axisymmetric, 0.5e-3, 1e-6), 1, gap);
  ASSERT_EQ(found.size(), 2u);
  for (const auto& cavity : found) {
    const double length = cavity.volume < M_PI * 100e-6 * 6e-3 ? 4e-3 : 8e-3;
    EXPECT_NEAR(cavity.volume, M_PI * 100e-6 * length, 1e-15);
    EXPECT_NEAR(cavity.tool_area[0], 0, 1e-15);
  }
}

TEST(AirCavities, a_planar_cavity_between_two_symmetry_planes_is_found) {
  Scenery scene(0, 10, 4, 12);
  scene.mesh.edit().boundaries[1].kind = core::BoundaryKind::symmetry;
  Outline floor = Pen(mm(10, 0)).contact(mm(0, 0)).free(mm(0, -5)).free(mm(10, -5)).close();
  scene.add(floor);
  std::vector<OutlinedTool> placed{{0, &scene.tools[0].profile, {false, true}, {true, false}, 0}};
  const auto outlines = tool_outlines(placed, Geometry::planar, 0.5e-3, 1e-6);
  const auto found =
      air_cavities({scene.mesh, Geometry::planar, exposed_edges(scene.mesh, scene.contact_tool), scene.contact_tool},
                   outlines, 1, gap);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].volume, 10e-3 * 4e-3, 1e-15);
}

}  // namespace
}  // namespace parison::forming
