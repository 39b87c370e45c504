// SPDX-License-Identifier: GPL-3.0-or-later
// Cells of a wall that have got bad are set right; mass, heat and fields come with them.
#include <gtest/gtest.h>

#include <cmath>

#include "forming/solid/straighten.hpp"
#include "remesh/solid/wall_straightening.hpp"
#include "solid/hex_block.hpp"

namespace parison::forming::test {
namespace {

using core::Index;
using core::Vector3;

const flow::Material glass = tests::uniform_glass(1e4);
constexpr Index along = 10, layers = 4;

const thermal::Material conducting{2500, core::constant(1282), core::constant(2.77), {}};

double linear(const Vector3& x) {
  return 1200 + 4000 * x[0] - 7000 * x[1] + 11000 * x[2];
}

/// Temperature and mass of the present mesh.
void fill(SolidState& solid) {
  const core::HexMesh& mesh = solid.glass.mesh;
  solid.glass.temperature.resize(mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) solid.glass.temperature[n] = linear(mesh.nodes[n]);
  solid.glass.velocity.resize(3 * mesh.node_count());
  for (Index n = 0; n < mesh.node_count(); ++n) solid.glass.velocity.segment<3>(3 * n) = 0.5 * mesh.nodes[n];
  solid.point_mass = thermal::point_masses(mesh.nodes, core::cell_list(mesh, core::hexahedron_table()), conducting,
                                           solid.glass.temperature);
  solid.glass.cell_mass = flow::masses_by_volume(glass, mesh, solid.glass.temperature);
}

/// A wall of 20 x 20 x 3 mm, flat or bent about the x axis, whose end x = 20 mm is the rim; the
/// others are on planes of symmetry.
SolidState wall(double bend) {
  SolidState solid;
  solid.glass.mesh = tests::hex_block(along, along, layers, [&](const Vector3& x) -> Vector3 {
    const double angle = bend * (x[1] - 0.5), radius = (bend > 0 ? 20e-3 / bend : 0) + 3e-3 * x[2];
    return bend > 0 ? Vector3(20e-3 * x[0], radius * std::sin(angle), radius * std::cos(angle))
                    : Vector3(20e-3 * x[0], 20e-3 * x[1], 3e-3 * x[2]);
  });
  for (const auto& face : core::test::boundary_faces(solid.glass.mesh)) {
    const Vector3 middle = solid.glass.mesh.nodes[core::face_node_numbers(solid.glass.mesh, face)[4]];
    const bool is_rim = face.axis == 0 && middle[0] > 10e-3;
    if (face.axis != 2 && !is_rim) continue;
    const SolidSide side = is_rim ? SolidSide::rim : face.end == 0 ? SolidSide::inner : SolidSide::outer;
    solid.faces.push_back(face);
    solid.heat_faces.push_back(core::quad_face(solid.glass.mesh, face, static_cast<Index>(side)));
  }
  solid.planes = {tests::plane_of(solid.glass.mesh, Vector3::UnitX())};
  for (const double end : {-0.5, 0.5}) {
    const Vector3 normal(0, std::cos(bend * end), -std::sin(bend * end));
    const double place = bend > 0 ? 0 : 10e-3 + 20e-3 * end;
    solid.planes.push_back({normal, tests::nodes_where(solid.glass.mesh, [&](const Vector3& x) {
                              return std::abs(x.dot(normal) - place) < 1e-9;
                            })});
  }
  const Index of_level = (2 * along + 1) * (2 * along + 1);
  for (Index s = 0; s < of_level; ++s) {
    solid.columns.emplace_back();
    for (Index k = 0; k <= 2 * layers; ++k) solid.columns.back().push_back(s + k * of_level);
  }
  fill(solid);
  return solid;
}

/// A node in the middle of the wall, so many steps of half cells from its corner, on a level from the inner side.
Vector3& node(SolidState& solid, Index i, Index j, Index level) {
  return solid.glass.mesh.nodes[solid.columns[i + (2 * along + 1) * j][level]];
}

double heat_of(const SolidState& solid) {
  return thermal::heat_content(thermal::solid_body(solid.glass.mesh, solid.heat_faces, solid.point_mass, conducting),
                               solid.glass.temperature);
}

double farthest_from_linear(const SolidState& solid) {
  double worst = 0;
  for (Index n = 0; n < solid.glass.mesh.node_count(); ++n)
    worst = std::max(worst, std::abs(solid.glass.temperature[n] - linear(solid.glass.mesh.nodes[n])));
  return worst;
}

TEST(SolidStraighten, good_cells_stay_as_they_are) {
  SolidState solid = wall(1);
  const auto before = solid.glass.mesh.nodes;
  EXPECT_FALSE(straighten(glass, conducting, solid));
  EXPECT_TRUE(before == solid.glass.mesh.nodes);
}

TEST(SolidStraighten, nodes_through_a_bent_wall_go_back_and_mass_heat_and_volume_stay) {
  SolidState solid = wall(1);
  for (const Index level : {3, 4, 5}) node(solid, 10, 10, level) += Vector3(0.42e-3, 0.14e-3, 0);
  ASSERT_LT(remesh::least_jacobian(solid.glass.mesh), 0.2);
  ASSERT_GT(remesh::least_jacobian(solid.glass.mesh), 0);
  fill(solid);
  // Not linear: what a transfer loses is to be seen.
  for (Index n = 0; n < solid.glass.temperature.size(); ++n)
    solid.glass.temperature[n] += 50 * std::sin(3000 * solid.glass.mesh.nodes[n].sum());
  const double heat = heat_of(solid), mass = solid.glass.cell_mass.sum(),
               volume = core::cell_volumes(solid.glass.mesh).sum();
  const Eigen::VectorXd temperature = solid.glass.temperature;
  ASSERT_TRUE(straighten(glass, conducting, solid));
  EXPECT_GT(remesh::least_jacobian(solid.glass.mesh), 0.3);
  EXPECT_GT((solid.glass.temperature - temperature).cwiseAbs().maxCoeff(), 1);
  EXPECT_NEAR(heat_of(solid) / heat, 1, 1e-12);
  EXPECT_NEAR(solid.glass.cell_mass.sum() / mass, 1, 1e-14);
  EXPECT_NEAR(solid.point_mass.sum() / mass, 1, 1e-14);
  EXPECT_NEAR(core::cell_volumes(solid.glass.mesh).sum() / volume, 1, 1e-12);
  // Far from the bad cells nothing has changed, to the bit.
  EXPECT_EQ(solid.glass.temperature[solid.columns[0][2]], temperature[solid.columns[0][2]]);
}

TEST(SolidStraighten, a_bad_cell_at_the_rim_keeps_no_other_from_being_set_right) {
  SolidState solid = wall(1);
  const Vector3 aside(-0.42e-3, 0.14e-3, 0);
  for (const Index level : {3, 4, 5}) {
    node(solid, 10, 10, level) += aside;
    node(solid, 2 * along, 10, level) += aside;
  }
  fill(solid);
  const Vector3 at_rim = node(solid, 2 * along, 10, 4);
  const auto least_of = [&](bool rim) {
    double least = 1;
    for (Index cell = 0; cell < solid.glass.mesh.cell_count(); ++cell)
      if ((core::cell_nodes(solid.glass.mesh, cell).row(0).maxCoeff() > 19.9e-3) == rim)
        least = std::min(least, core::least_jacobian(solid.glass.mesh, cell));
    return least;
  };
  ASSERT_LT(least_of(false), 0.2);
  const double rim = least_of(true);
  ASSERT_LT(rim, 0.2);
  ASSERT_TRUE(straighten(glass, conducting, solid));
  EXPECT_GT(least_of(false), 0.3);
  EXPECT_GE(least_of(true), rim);
  EXPECT_EQ(at_rim, node(solid, 2 * along, 10, 4));
}

TEST(SolidStraighten, columns_that_lean_far_are_set_right_and_a_linear_temperature_stays) {
  SolidState solid = wall(0);
  // The inner side has been pulled along under the outer one, nearly twice as far as the wall is thick, as glass is
  // that a mould holds on its outer side while air stretches what is below it.
  constexpr double farthest = 6.15e-3;
  for (const auto& column : solid.columns)
    for (std::size_t k = 0; k < column.size(); ++k) {
      Vector3& x = solid.glass.mesh.nodes[column[k]];
      const double inner = 1 - x[2] / 3e-3, along_wall = std::sin(M_PI * x[0] / 20e-3);
      x[0] -= farthest * inner * inner * along_wall * along_wall;
    }
  ASSERT_LT(remesh::least_jacobian(solid.glass.mesh), 0.2);
  ASSERT_GT(remesh::least_jacobian(solid.glass.mesh), 0);
  fill(solid);
  const double before = remesh::least_jacobian(solid.glass.mesh);
  const double heat = heat_of(solid), volume = core::cell_volumes(solid.glass.mesh).sum();
  ASSERT_TRUE(straighten(glass, conducting, solid));
  EXPECT_GT(remesh::least_jacobian(solid.glass.mesh), before + 0.02);
  EXPECT_LT(farthest_from_linear(solid), 1e-6);
  EXPECT_NEAR(heat_of(solid) / heat, 1, 1e-12);
  EXPECT_NEAR(core::cell_volumes(solid.glass.mesh).sum() / volume, 1, 1e-12);
}

TEST(SolidStraighten, columns_slide_along_the_sides_and_keep_a_linear_temperature) {
  SolidState solid = wall(0);
  // A whole column between cells, with its edges, is pushed along the wall; another on the plane.
  for (Index k = 0; k <= 2 * layers; ++k) {
    node(solid, 10, 10, k) += Vector3(0.55e-3, 0.1e-3, 0);
    node(solid, 0, 10, k) += Vector3(0, 0.58e-3, 0);
  }
  ASSERT_LT(remesh::least_jacobian(solid.glass.mesh), 0.2);
  ASSERT_GT(remesh::least_jacobian(solid.glass.mesh), 0);
  fill(solid);
  const double heat = heat_of(solid), volume = core::cell_volumes(solid.glass.mesh).sum();
  ASSERT_TRUE(straighten(glass, conducting, solid));
  EXPECT_GT(remesh::least_jacobian(solid.glass.mesh), 0.2);
  EXPECT_LT(farthest_from_linear(solid), 1e-6);
  EXPECT_NEAR(heat_of(solid) / heat, 1, 1e-12);
  EXPECT_NEAR(core::cell_volumes(solid.glass.mesh).sum() / volume, 1, 1e-12);
  for (Index n = 0; n < solid.glass.mesh.node_count(); ++n)
    EXPECT_LT((solid.glass.velocity.segment<3>(3 * n) - 0.5 * solid.glass.mesh.nodes[n]).norm(), 1e-12);
  for (const Index n : solid.planes.front().nodes) EXPECT_EQ(solid.glass.mesh.nodes[n][0], 0);
  for (const auto& column : solid.columns) {
    EXPECT_NEAR(solid.glass.mesh.nodes[column.front()][2], 0, 1e-15);
    EXPECT_NEAR(solid.glass.mesh.nodes[column.back()][2], 3e-3, 1e-15);
  }
}

}  // namespace
}  // namespace parison::forming::test
