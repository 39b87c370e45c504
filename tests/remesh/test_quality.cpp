// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/element.hpp"
#include "remesh/mesher/quality.hpp"

namespace parison::remesh {
namespace {

using core::Mesh;
using core::Point;

Mesh one_triangle(const Point& a, const Point& b, const Point& c) {
  return core::make_quadratic_mesh({a, b, c}, {{0, 1, 2}});
}

TEST(Quality, an_equilateral_triangle_has_one) {
  EXPECT_NEAR(quality(one_triangle({1, 1}, {2, 1}, {1.5, 1 + std::sqrt(3.0) / 2})).min, 1, 1e-14);
}

TEST(Quality, a_straight_triangle_follows_the_formula_of_area_and_sides) {
  const Point a(0, 0), b(3, 0.2), c(0.4, 1.1);
  const double area = 0.5 * (b[0] * c[1] - b[1] * c[0]);
  const double sides = (a - b).squaredNorm() + (b - c).squaredNorm() + (c - a).squaredNorm();
  EXPECT_NEAR(quality(one_triangle(a, b, c)).min, 4 * std::sqrt(3.0) * area / sides, 1e-14);
}

TEST(Quality, a_curved_edge_that_folds_its_cell_shows_although_the_vertices_are_fine) {
  Mesh mesh = one_triangle({0, 0}, {1, 0}, {0.5, 0.8});
  const double straight = quality(mesh).min;
  mesh.nodes[3][1] = 0.1;
  const double bent = quality(mesh).min;
  mesh.nodes[3][1] = 0.5;
  EXPECT_GT(straight, 0.9);
  EXPECT_LT(bent, straight);
  EXPECT_GT(bent, 0);
  EXPECT_LE(quality(mesh).min, 0);
}

TEST(Quality, a_curved_cell_has_the_least_value_of_its_jacobian_at_the_six_nodes) {
  Mesh mesh = one_triangle({0.2, 0.1}, {1.3, 0}, {0.6, 0.9});
  mesh.nodes[3] += Point(0.03, 0.07);
  mesh.nodes[4] += Point(-0.05, 0.02);
  mesh.nodes[5] += Point(0.04, -0.06);
  double least = 1;
  for (const auto& [a, b] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}, {0.5, 0.0}, {0.5, 0.5}, {0.0, 0.5}}) {
    const auto derivative = core::triangle_shape_derivative(a, b);
    Point along_a = Point::Zero(), along_b = Point::Zero();
    for (int i = 0; i < 6; ++i) {
      along_a += derivative[i][0] * mesh.nodes[mesh.cells()[0][i]];
      along_b += derivative[i][1] * mesh.nodes[mesh.cells()[0][i]];
    }
    // Against the equilateral triangle, whose third corner stands over the middle of the first side.
    const Point up = (2 * along_b - along_a) / std::sqrt(3.0);
    const double determinant = along_a[0] * up[1] - along_a[1] * up[0];
    least = std::min(least, 2 * determinant / (along_a.squaredNorm() + up.squaredNorm()));
  }
  EXPECT_LT(least, 0.9 * quality(one_triangle({0.2, 0.1}, {1.3, 0}, {0.6, 0.9})).min);
  EXPECT_NEAR(cell_quality(mesh, 0), least, 1e-14);
}

TEST(Quality, the_worst_cell_is_named) {
  const Mesh mesh = core::make_quadratic_mesh({{0, 0}, {1, 0}, {0.5, 0.9}, {0.5, -0.05}}, {{0, 1, 2}, {0, 3, 1}});
  const Quality q = quality(mesh);
  EXPECT_EQ(q.min_quality_cell, 1);
  EXPECT_NEAR(q.mean, 0.5 * (cell_quality(mesh, 0) + cell_quality(mesh, 1)), 1e-15);
  EXPECT_EQ(q.min, cell_quality(mesh, 1));
}

}  // namespace
}  // namespace parison::remesh
