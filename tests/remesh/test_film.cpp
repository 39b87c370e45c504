// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/profiles.hpp"
#include "remesh/surface/film.hpp"

namespace parison::remesh {
namespace {

using core::Index;
using core::Mesh;

/// A wedge of 20 mm length, 0.5 mm thick at its thin end, opening by `angle`; its sides are "bottom" and "top".
Mesh wedge(double angle) {
  const double far = 0.5 + 20 * std::tan(angle * M_PI / 180);
  const core::Profile profile =
      Pen(10, 0).line(30, 0, "bottom").line(30, far, "right").line(10, 0.5, "top").line(10, 0, "left").closed();
  return mesh_profile(profile, {0.5e-3, 0.5e-3, 0.3, std::vector<bool>(4, false)});
}

/// Share of the nodes of the bottom that see a film, with the named boundaries in contact; `mirror` is a symmetry
/// boundary.
double share_of_film(Mesh mesh, const std::vector<std::string>& touching, const std::string& mirror = "") {
  std::vector<bool> contact(mesh.nodes.size(), false);
  for (auto& boundary : mesh.edit().boundaries)
    if (boundary.name == mirror) boundary.kind = core::BoundaryKind::symmetry;
  for (const std::string& name : touching)
    for (const auto& edge : mesh.boundary_edges())
      if (edge.boundary_id == core::find_boundary(mesh, name))
        for (const Index node : edge.nodes) contact[node] = true;
  const Eigen::VectorXd film = film_thickness(mesh, remesh::surface_wall(mesh), contact);
  double thin = 0, all = 0;
  for (const auto& edge : mesh.boundary_edges())
    if (edge.boundary_id == core::find_boundary(mesh, "bottom")) {
      all += 1;
      thin += std::isfinite(film[edge.nodes[2]]);
    }
  return thin / all;
}

TEST(Film, glass_is_one_where_tools_press_on_both_sides_and_nowhere_else) {
  const Mesh slab = wedge(0);
  EXPECT_EQ(share_of_film(slab, {"bottom", "top"}), 1);
  EXPECT_EQ(share_of_film(slab, {"bottom"}), 0);
  EXPECT_EQ(share_of_film(slab, {"bottom"}, "top"), 1) << "half of a film and its mirror image";
}

TEST(Film, a_rim_that_tapers_off_between_tools_is_none) {
  EXPECT_EQ(share_of_film(wedge(10), {"bottom", "top"}), 1);
  EXPECT_EQ(share_of_film(wedge(25), {"bottom", "top"}), 0);
}

TEST(Film, a_lip_whose_tip_alone_touches_another_tool_is_none) {
  const Mesh lip = wedge(0);
  std::vector<Index> tool(lip.nodes.size(), -1);
  const auto touch = [&](const std::string& name, Index which, double from) {
    for (const auto& edge : lip.boundary_edges())
      if (edge.boundary_id == core::find_boundary(lip, name))
        for (const Index node : edge.nodes)
          if (lip.nodes[node][0] >= from) tool[node] = which;
  };
  const auto is_film = [&] {
    const Eigen::VectorXd film = film_between_tools(lip, surface_wall(lip), tool);
    return std::any_of(film.begin(), film.end(), [](double t) { return std::isfinite(t); });
  };
  touch("bottom", 0, 0);
  touch("top", 1, 29.9e-3);
  EXPECT_FALSE(is_film());
  touch("top", 1, 28e-3);
  EXPECT_TRUE(is_film());
}

TEST(Film, sizes_put_four_elements_across_up_to_a_millimetre) {
  for (const double thickness : {0.3e-3, 0.7e-3, 1e-3}) EXPECT_DOUBLE_EQ(film_size(thickness, 0.3e-3), thickness / 4);
  EXPECT_DOUBLE_EQ(film_size(2e-3, 0.3e-3), 1e-3);
  EXPECT_DOUBLE_EQ(film_size(0.1e-3, 0.3e-3), 0.3e-3 / 4);
}

}  // namespace
}  // namespace parison::remesh
