// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "remesh/surface/wall_thickness.hpp"

namespace parison::remesh {

using namespace core;
namespace {

/// Structured mesh of the image of the unit square, mid-side nodes mapped too; boundaries "bottom", "right", "top",
/// "left".
Mesh mapped_square(Index columns, Index rows, const std::function<Point(double, double)>& map) {
  std::vector<Point> vertices;
  std::vector<std::array<Index, 3>> triangles;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) vertices.emplace_back(double(i) / columns, double(j) / rows);
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, b = a + 1, c = b + columns + 1, d = c - 1;
      triangles.push_back({a, b, c});
      triangles.push_back({a, c, d});
    }
  Mesh mesh = make_quadratic_mesh(vertices, triangles);
  mesh.edit().boundaries = {"bottom", "right", "top", "left"};
  for (BoundaryEdge& edge : mesh.edit().boundary_edges) {
    const Point& x = mesh.nodes[edge.nodes[2]];
    edge.boundary_id = x[1] == 0 ? 0 : x[0] == 1 ? 1 : x[1] == 1 ? 2 : 3;
  }
  for (Point& x : mesh.nodes) x = map(x[0], x[1]);
  return mesh;
}

Mesh with_symmetry(Mesh mesh, const std::vector<std::string>& boundaries) {
  for (const auto& name : boundaries) mesh.edit().boundaries[find_boundary(mesh, name)].kind = BoundaryKind::symmetry;
  return mesh;
}

std::vector<Index> nodes_of(const Mesh& mesh, Index boundary) {
  std::vector<Index> nodes;
  for (const BoundaryEdge& edge : mesh.boundary_edges())
    if (edge.boundary_id == boundary) nodes.insert(nodes.end(), edge.nodes.begin(), edge.nodes.end());
  return nodes;
}

TEST(Thickness, a_slab_is_as_thick_as_it_is) {
  const Mesh mesh = mapped_square(30, 4, [](double x, double y) { return Point(0.1 * x, 3e-3 * y); });
  const Eigen::VectorXd wall = wall_thickness(with_symmetry(mesh, {"right", "left"}));
  for (Index i = 0; i < mesh.node_count(); ++i) EXPECT_NEAR(wall[i], 3e-3, 1e-14);
}

TEST(Thickness, a_slab_cut_out_of_a_wall_by_insulated_faces_is_as_thick_as_the_wall) {
  const auto slab = [](const std::vector<std::string>& insulated) {
    Mesh mesh = mapped_square(8, 4, [](double u, double v) { return Point(2e-3 * u, 5e-3 * v); });
    for (const auto& name : insulated) mesh.edit().boundaries[find_boundary(mesh, name)].kind = BoundaryKind::insulated;
    return wall_thickness(mesh);
  };
  EXPECT_LT((slab({"left", "right"}).array() - 5e-3).abs().maxCoeff(), 1e-15);
  EXPECT_LT((slab({"left", "right", "top"}).array() - 10e-3).abs().maxCoeff(), 1e-15);
  EXPECT_LT(slab({}).minCoeff(), 2.1e-3);
}

TEST(Thickness, a_wedge_is_thick_in_proportion_to_the_distance_from_its_edge) {
  const Mesh mesh =
      mapped_square(40, 3, [](double x, double y) { return Point(0.01 + 0.1 * x, 0.1 * y * (0.01 + 0.1 * x)); });
  const Eigen::VectorXd wall = wall_thickness(mesh);
  int checked = 0;
  for (const Index i : nodes_of(mesh, 0)) {
    if (mesh.nodes[i][0] < 0.02 || mesh.nodes[i][0] > 0.1) continue;
    EXPECT_NEAR(wall[i], 0.1 * mesh.nodes[i][0], 1e-12);
    ++checked;
  }
  EXPECT_GT(checked, 50);
}

TEST(Thickness, a_spherical_shell_has_its_wall_everywhere) {
  const Mesh mesh = mapped_square(24, 4, [](double u, double v) {
    const double radius = 30e-3 - 2e-3 * v, angle = M_PI / 2 * u;
    return Point(radius * std::cos(angle), radius * std::sin(angle));
  });
  const Eigen::VectorXd wall = wall_thickness(with_symmetry(mesh, {"right", "left"}));
  for (Index i = 0; i < mesh.node_count(); ++i) EXPECT_NEAR(wall[i], 2e-3, 2e-6);
}

TEST(Thickness, a_rod_is_as_thick_as_its_diameter) {
  const Mesh mesh = mapped_square(5, 30, [](double x, double y) { return Point(8e-3 * x, 0.2 * y); });
  const Eigen::VectorXd wall = wall_thickness(with_symmetry(mesh, {"left"}));
  for (const Index i : nodes_of(mesh, 1))
    if (mesh.nodes[i][1] > 0.01 && mesh.nodes[i][1] < 0.19) EXPECT_NEAR(wall[i], 16e-3, 1e-14);
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (mesh.nodes[i][1] > 0.02 && mesh.nodes[i][1] < 0.18) EXPECT_NEAR(wall[i], 16e-3, 1e-14) << "inside";
}

TEST(Thickness, each_node_inside_takes_the_wall_near_it) {
  const auto height = [](double x) { return 2e-3 + 6e-3 * x; };
  const Mesh mesh = mapped_square(60, 4, [&](double x, double y) { return Point(0.3 * x, height(x) * y); });
  const Eigen::VectorXd wall = wall_thickness(with_symmetry(mesh, {"right", "left"}));
  for (Index i = 0; i < mesh.node_count(); ++i) EXPECT_NEAR(wall[i], height(mesh.nodes[i][0] / 0.3), 0.2e-3);
}

}  // namespace
}  // namespace parison::remesh
