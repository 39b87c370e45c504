// SPDX-License-Identifier: GPL-3.0-or-later
// A container in space as a STEP solid.
#include <gtest/gtest.h>

#include <cmath>

#include "../../test_folder.hpp"
#include "core/mesh/element.hpp"
#include "core/process/run_error.hpp"
#include "forming/report/solid/space_files.hpp"
#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/profiles.hpp"
#include "remesh/solid/wall_mesh.hpp"
#include "step_volume.hpp"

namespace parison::forming {
namespace {

/// A deep cup with a flat rim and rounded corners.
core::Mesh cup() {
  const core::Profile outline = remesh::Pen(0, 3)
                                    .line(16, 3, "inner")
                                    .arc(16, 7, -90, 0, "inner")
                                    .line(20, 60, "inner")
                                    .line(22.5, 60, "outer")
                                    .line(22.5, 6, "outer")
                                    .arc(16.5, 6, 0, -90, "outer")
                                    .line(0, 0, "outer")
                                    .line(0, 3, "axis")
                                    .closed();
  core::Mesh mesh =
      remesh::mesh_profile(outline, {1.6e-3, 0.8e-3, 0.3, std::vector<bool>(outline.boundary_names.size(), true)});
  for (auto& boundary : mesh.edit().boundaries)
    boundary.kind = boundary.name == "axis" ? core::BoundaryKind::symmetry : core::BoundaryKind::contact;
  return mesh;
}

/// The cup turned about its axis in a sector, rad.
SolidState turned(double sector) {
  const core::Mesh section = cup();
  const auto sides = remesh::wall_sides(section, core::Geometry::axisymmetric,
                                        remesh::surface_rays(section, core::Geometry::axisymmetric));
  remesh::WallMesh wall = remesh::turn_wall({section, sides}, {3e-3, 3, sector});
  SolidState solid;
  solid.glass.mesh = std::move(wall.mesh);
  const auto add = [&](const std::vector<core::HexFace>& faces, SolidSide side) {
    for (const core::HexFace& face : faces) {
      solid.faces.push_back(face);
      solid.heat_faces.push_back(core::quad_face(solid.glass.mesh, face, static_cast<Index>(side)));
    }
  };
  add(wall.inner, SolidSide::inner);
  add(wall.outer, SolidSide::outer);
  add(wall.rim, SolidSide::rim);
  solid.columns = std::move(wall.columns);
  solid.share = sector / (2 * M_PI);
  return solid;
}

/// Blown out towards its corners, the further from the axis and from the rim the more; `depth` of y over that of x.
void make_square(double depth, SolidState& solid) {
  for (core::Vector3& x : solid.glass.mesh.nodes) {
    const double r = std::hypot(x[0], x[1]), away = std::clamp(1 - x[2] / 0.06, 0.0, 1.0),
                 far = std::min(1.0, r / 0.02);
    if (r == 0) continue;
    const double corner = std::pow(std::pow(x[0] / r, 4) + std::pow(x[1] / r, 4), -0.25);
    const double wider = 1 + (corner - 1) * far * far * away;
    x[0] *= wider;
    x[1] *= wider * (1 + (depth - 1) * far * far * away);
  }
}

/// Beside its volume, m3.
void expect_solid(const SolidState& solid, double glass) {
  const std::string path = tests::new_folder() + "/cup.step";
  const SmoothSolid made = write_step(path, solid);
  EXPECT_NEAR(made.volume / glass, 1, 1e-3);
  EXPECT_NEAR(volume_of_step(path) / glass, 1, 1e-3);
  EXPECT_LT(made.from_nodes, 1e-9);
  EXPECT_LT(made.from_faces, 1e-4);
}

TEST(SpaceStep, a_round_cup_of_any_sector_is_a_closed_solid_of_its_volume) {
  const core::Mesh section = cup();
  double exact = 0;
  for (core::Index c = 0; c < section.cell_count(); ++c)
    for (const auto& rule : core::triangle_rule(6))
      exact += core::map_cell_point(section, c, core::Geometry::axisymmetric, rule).volume;
  for (const double parts : {4.0, 1.0, 24.0}) expect_solid(turned(2 * M_PI / parts), exact);
}

TEST(SpaceStep, a_cup_that_is_not_round_is_a_closed_solid_of_its_volume) {
  for (const double parts : {4.0, 2.0}) {
    SolidState solid = turned(2 * M_PI / parts);
    make_square(0.8, solid);
    expect_solid(solid, whole_volume(solid));
  }
}

TEST(SpaceStep, a_wall_that_crosses_itself_is_refused) {
  SolidState solid = turned(M_PI_2);
  for (const auto& column : solid.columns)
    std::swap(solid.glass.mesh.nodes[column.front()][2], solid.glass.mesh.nodes[column.back()][2]);
  try {
    write_step(tests::new_folder() + "/cup.step", solid);
    ADD_FAILURE() << "it was taken";
  } catch (const core::RunError& error) {
    EXPECT_NE(std::string(error.what()).find("crosses itself"), std::string::npos) << error.what();
  }
}

TEST(SpaceStep, a_sector_that_does_not_make_a_whole_turn_is_refused) {
  SolidState solid = turned(M_PI_2);
  solid.share = 0.3;
  EXPECT_THROW(write_step(tests::new_folder() + "/cup.step", solid), core::RunError);
}

}  // namespace
}  // namespace parison::forming
