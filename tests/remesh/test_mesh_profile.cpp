// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "core/mesh/element.hpp"
#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/mesher/quality.hpp"
#include "remesh/profiles.hpp"
#include "remesh/show.hpp"

namespace parison::remesh {
namespace {

using core::Index;
using core::Mesh;
using core::Point;
using core::Profile;

/// Volume of revolution by Green's theorem over the exact outline, Gauss points in parts of each segment.
double exact_volume(const Profile& profile) {
  double sum = 0;
  for (const core::Segment& segment : profile.segments)
    for (int part = 0; part < 64; ++part)
      for (const auto& at : core::edge_rule(5)) {
        const double t = (part + at.s) / 64;
        const double r = core::point_at(segment, t)[0];
        sum += at.weight / 64 * core::length(segment) * M_PI * r * r * core::tangent_at(segment, t)[1];
      }
  return sum;
}

ProfileSizes sizes_for(const Profile& profile, const std::string& fine) {
  ProfileSizes sizes{6e-3, 0.8e-3, 0.3, {}};
  for (const std::string& name : profile.boundary_names) sizes.fine_boundaries.push_back(name == fine);
  return sizes;
}

struct Case {
  const char* name;
  Profile profile;
  const char* fine;
};

std::vector<Case> jar() {
  return {{"gob", gob(), "surface"},
          {"blank", blank(), "cavity"},
          {"plunger", plunger(), "outer"},
          {"blow_mould", blow_mould(), "cavity"},
          {"neck_ring", neck_ring(), "cavity"}};
}

void expect_chained(const Mesh& mesh, const Profile& profile) {
  for (std::size_t i = 0; i < mesh.boundary_edges().size(); ++i) {
    const auto& edge = mesh.boundary_edges()[i];
    EXPECT_EQ(edge.nodes[1], mesh.boundary_edges()[(i + 1) % mesh.boundary_edges().size()].nodes[0]);
    EXPECT_GE(edge.nodes[2], mesh.vertex_count());
    for (const Index node : edge.nodes) {
      double nearest = 1;
      for (const core::Segment& segment : profile.segments)
        if (segment.boundary_id == edge.boundary_id) {
          const Point foot = core::point_at(segment, core::closest_parameter(segment, mesh.nodes[node]));
          nearest = std::min(nearest, (foot - mesh.nodes[node]).norm());
        }
      EXPECT_LT(nearest, 1e-15) << "node off its boundary " << mesh.boundaries()[edge.boundary_id].name;
    }
    const auto& cell = mesh.cells()[edge.cell];
    for (const Index node : edge.nodes) EXPECT_NE(std::find(cell.begin(), cell.end(), node), cell.end());
  }
}

TEST(MeshProfile, the_bodies_of_the_jar_are_well_shaped_and_keep_their_volume) {
  for (const Case& body : jar()) {
    const Mesh mesh = mesh_profile(body.profile, sizes_for(body.profile, body.fine));
    const Quality q = quality(mesh);
    const double exact = exact_volume(body.profile);
    const double error = core::volume(mesh, core::Geometry::axisymmetric) / exact - 1;
    std::printf("%-10s %5d cells, quality worst %.3f median %.3f, volume error %.1e\n", body.name, mesh.cell_count(),
                q.min, q.median, error);
    show(mesh, body.name);
    EXPECT_GE(q.min, 0.3) << body.name;
    EXPECT_GE(q.median, 0.9) << body.name;
    EXPECT_LT(std::abs(error), 1e-6) << body.name;
    std::vector<std::string> names;
    for (const auto& boundary : mesh.boundaries()) names.push_back(boundary.name);
    EXPECT_EQ(names, body.profile.boundary_names);
    expect_chained(mesh, body.profile);
  }
}

TEST(MeshProfile, the_gob_holds_its_91_cubic_centimetres) {
  const double exact = exact_volume(gob());
  EXPECT_NEAR(exact, M_PI * 26 * 26 * 8.4e-9 + 4.0 / 3 * M_PI * 26 * 26 * 26e-9, 1e-16);
  EXPECT_NEAR(exact, 91.5e-6, 0.1e-6);
}

TEST(MeshProfile, edges_are_fine_at_the_contact_boundary_and_grow_away_from_it) {
  const Profile profile = blank();
  const ProfileSizes sizes = sizes_for(profile, "cavity");
  const Mesh mesh = mesh_profile(profile, sizes);
  double finest = 1, coarsest = 0;
  for (const auto& edge : mesh.boundary_edges()) {
    const double length = (mesh.nodes[edge.nodes[0]] - mesh.nodes[edge.nodes[1]]).norm();
    if (mesh.boundaries()[edge.boundary_id].name == "cavity") EXPECT_LE(length, 1.2 * sizes.contact_size);
    if (mesh.boundaries()[edge.boundary_id].name == "cavity") finest = std::min(finest, length);
    if (mesh.boundaries()[edge.boundary_id].name == "outside") coarsest = std::max(coarsest, length);
  }
  EXPECT_GT(finest, 0.4 * sizes.contact_size);
  EXPECT_GT(coarsest, 4e-3);
  EXPECT_LE(coarsest, 1.2 * sizes.size);
}

TEST(MeshProfile, the_same_profile_gives_the_same_bits) {
  const Profile profile = plunger();
  const ProfileSizes sizes = sizes_for(profile, "outer");
  const Mesh first = mesh_profile(profile, sizes);
  mesh_profile(blank(), sizes_for(blank(), "cavity"));
  std::rand();
  const Mesh second = mesh_profile(profile, sizes);
  ASSERT_EQ(first.node_count(), second.node_count());
  EXPECT_EQ(first.cells(), second.cells());
  for (Index i = 0; i < first.node_count(); ++i) ASSERT_EQ(first.nodes[i], second.nodes[i]);
}

TEST(MeshProfile, an_outline_that_crosses_itself_is_refused_and_the_next_body_still_meshes) {
  const Profile bow = Pen(1, 0).line(20, 20, "a").line(1, 20, "a").line(20, 0, "a").line(1, 0, "a").closed();
  EXPECT_THROW(mesh_profile(bow, {5e-3, 5e-3, 0.3, {false}}), std::runtime_error);
  EXPECT_GT(mesh_profile(blank(), sizes_for(blank(), "cavity")).cell_count(), 100);
}

TEST(MeshMapped, a_graded_block_has_the_asked_divisions_and_ratio) {
  const Profile block =
      Pen(5, 0).line(15, 0, "bottom").line(15, 20, "right").line(5, 20, "top").line(5, 0, "left").closed();
  const Mesh mesh = mesh_mapped(block, 5, 8, 1, 10);
  EXPECT_EQ(mesh.cell_count(), 2 * 5 * 8);
  EXPECT_EQ(mesh.vertex_count(), 6 * 9);
  expect_chained(mesh, block);
  std::vector<double> lengths;
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.boundaries()[edge.boundary_id].name == "right")
      lengths.push_back((mesh.nodes[edge.nodes[0]] - mesh.nodes[edge.nodes[1]]).norm());
  ASSERT_EQ(lengths.size(), 8u);
  EXPECT_NEAR(lengths.back() / lengths.front(), 10, 1e-9);
  for (int i = 0; i + 2 < 8; ++i) EXPECT_NEAR(lengths[i + 2] / lengths[i + 1], lengths[i + 1] / lengths[i], 1e-9);
  EXPECT_NEAR(core::volume(mesh, core::Geometry::axisymmetric) / exact_volume(block), 1, 1e-13);
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.boundaries()[edge.boundary_id].name == "left") EXPECT_EQ(mesh.nodes[edge.nodes[2]][0], 5e-3);
}

TEST(MeshMapped, arcs_are_followed_inside_and_out) {
  const Profile shell =
      Pen(20, 0).line(24, 0, "cut").arc(0, 0, 0, 90, "outer").line(0, 20, "axis").arc(0, 0, 90, 0, "inner").closed();
  const Mesh mesh = mesh_mapped(shell, 4, 24, 3, 1);
  expect_chained(mesh, shell);
  EXPECT_NEAR(core::volume(mesh, core::Geometry::axisymmetric) / exact_volume(shell), 1, 1e-6);
  EXPECT_GT(quality(mesh).min, 0.3);
  for (const Point& x : mesh.nodes) {
    EXPECT_GT(x.norm(), 20e-3 - 1e-12);
    EXPECT_LT(x.norm(), 24e-3 + 1e-12);
  }
  show(mesh, "shell");
}

TEST(MeshMapped, five_boundaries_are_refused) {
  const Profile five =
      Pen(5, 0).line(9, 0, "a").line(15, 0, "b").line(15, 20, "c").line(5, 20, "d").line(5, 0, "e").closed();
  EXPECT_THROW(mesh_mapped(five, 4, 4, 1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace parison::remesh
