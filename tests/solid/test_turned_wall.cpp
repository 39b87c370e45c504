// SPDX-License-Identifier: GPL-3.0-or-later
// The section of a parison turned about the axis: its cells, and a chilled skin in it.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/mesh/element.hpp"
#include "core/solid/hex_geometry.hpp"
#include "figure.hpp"
#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/profiles.hpp"
#include "remesh/solid/column_values.hpp"
#include "remesh/solid/wall_straightening.hpp"

namespace parison::remesh {
namespace {

using core::Index;

/// A parison for a bottle: a round rim, beads on the finish, and a base three times as thick as the plunger's tip is
/// round.
core::Profile parison() {
  return Pen(0, 110)
      .arc(0, 105, 90, 0, "inner")
      .line(8.5, 30, "inner")
      .line(8.5, 0, "inner")
      .line(12, 0, "outer")
      .arc(12, 2, -90, 0, "outer")
      .line(13.2, 6, "outer")
      .line(13.2, 9, "outer")
      .line(14, 11, "outer")
      .line(13.2, 15, "outer")
      .line(13.2, 17, "outer")
      .line(12.6, 27, "outer")
      .line(16.5, 80, "outer")
      .line(16.5, 113, "outer")
      .arc(4.5, 113, 0, 90, "outer")
      .line(0, 125, "outer")
      .line(0, 110, "axis")
      .closed();
}

core::Mesh meshed(const core::Profile& outline) {
  core::Mesh mesh =
      mesh_profile(outline, {1.6e-3, 0.8e-3, 0.3, std::vector<bool>(outline.boundary_names.size(), true)});
  for (auto& boundary : mesh.edit().boundaries)
    boundary.kind = boundary.name == "axis" ? core::BoundaryKind::symmetry : core::BoundaryKind::contact;
  return mesh;
}

WallMesh turned(const core::Mesh& section, double size, Index layers) {
  const auto sides =
      wall_sides(section, core::Geometry::axisymmetric, surface_rays(section, core::Geometry::axisymmetric));
  return turn_wall({section, sides}, {size, layers, M_PI_2});
}

/// Volume of a section turned once about the axis, m3, and the mean of a nodal field in it.
std::array<double, 2> volume_and_mean(const core::Mesh& section, const Eigen::VectorXd& field) {
  double volume = 0, sum = 0;
  for (Index c = 0; c < section.cell_count(); ++c)
    for (const auto& rule : core::triangle_rule(6)) {
      const core::CellPoint point = core::map_cell_point(section, c, core::Geometry::axisymmetric, rule);
      volume += point.volume;
      for (int i = 0; i < 6; ++i) sum += point.volume * point.shape[i] * field[section.cells()[c][i]];
    }
  return {volume, sum / volume};
}

/// The same of a mesh in space.
std::array<double, 2> volume_and_mean(const core::HexMesh& mesh, const Eigen::VectorXd& field) {
  const core::HexRule& rule = core::hex_rule(3, 3);
  double volume = 0, sum = 0;
  for (Index c = 0; c < mesh.cell_count(); ++c)
    for (std::size_t q = 0; q < rule.at.size(); ++q) {
      const double part = core::map_hex_point(core::cell_nodes(mesh, c), rule, q).volume;
      volume += part;
      for (int n = 0; n < core::HexMesh::nodes_per_cell; ++n)
        sum += part * rule.shape(n, static_cast<Index>(q)) * field[mesh.cells[c][n]];
    }
  return {volume, sum / volume};
}

TEST(TurnedWall, a_round_rim_and_a_thick_base_on_a_small_tip_fold_no_cell) {
  const core::Mesh section = meshed(parison());
  const double exact = volume_and_mean(section, Eigen::VectorXd::Zero(section.node_count()))[0];
  for (const double size : {1.4e-3, 3e-3, 5e-3})
    for (const Index layers : {3, 4}) {
      const WallMesh wall = turned(section, size, layers);
      EXPECT_GT(least_jacobian(wall.mesh), 0.2) << size << " " << layers;
      EXPECT_NEAR(4 * core::cell_volumes(wall.mesh).sum(), exact, 0.01 * exact) << size << " " << layers;
    }
}

TEST(TurnedWall, sides_that_meet_on_a_round_end_leave_a_rim_between_them) {
  const core::Mesh section = meshed(Pen(0, 60)
                                        .arc(0, 51.5, 90, 0, "inner")
                                        .line(8.5, 2.75, "inner")
                                        .arc(11.25, 2.75, 180, 270, "inner")
                                        .arc(11.25, 2.75, 270, 360, "outer")
                                        .line(14, 55, "outer")
                                        .arc(0, 55, 0, 90, "outer")
                                        .line(0, 60, "axis")
                                        .closed());
  auto sides = wall_sides(section, core::Geometry::axisymmetric, surface_rays(section, core::Geometry::axisymmetric));
  for (std::size_t e = 0; e < sides.part.size(); ++e)
    if (sides.part[e] == SurfacePart::rim)
      sides.part[e] = section.boundaries()[section.boundary_edges()[e].boundary_id].name == "inner"
                          ? SurfacePart::inner
                          : SurfacePart::outer;
  const WallMesh wall = turn_wall({section, sides}, {3e-3, 3, M_PI_2});
  EXPECT_FALSE(wall.rim.empty());
  EXPECT_GT(least_jacobian(wall.mesh), 0.2);
}

TEST(TurnedWall, a_chilled_skin_keeps_its_heat_and_gets_no_hotter_than_it_was) {
  const core::Profile outline = parison();
  const core::Mesh section = meshed(outline);
  constexpr double hot = 1400, cold = 900, skin = 0.7e-3;
  Eigen::VectorXd temperature(section.node_count());
  for (Index n = 0; n < section.node_count(); ++n) {
    double depth = 1;
    for (const core::Segment& segment : outline.segments)
      if (outline.boundary_names[segment.boundary_id] != "axis")
        depth = std::min(depth, core::distance(segment, section.nodes[n], depth));
    temperature[n] = hot - (hot - cold) * std::erfc(depth / skin);
  }
  const WallMesh wall = turned(section, 3e-3, 3);
  const Eigen::VectorXd values = column_values(section, temperature, wall);
  tests::Figure off("chilled parison handed over into space: mean temperature off by", "K");
  off.add(std::abs(volume_and_mean(wall.mesh, values)[1] - volume_and_mean(section, temperature)[1]));
  off.at_most(5);
  EXPECT_LE(values.maxCoeff(), temperature.maxCoeff() + 0.02 * (hot - cold));
  EXPECT_LT(values.minCoeff(), cold + 0.4 * (hot - cold));
}

}  // namespace
}  // namespace parison::remesh
