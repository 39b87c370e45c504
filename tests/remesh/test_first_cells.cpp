// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "remesh/mesher/triangulate.hpp"

namespace parison::remesh {
namespace {

using core::Index;
using core::Point;

constexpr int bottom = 0, sides = 1, top = 2;

struct Grid {
  Outline outline;
  Triangulation mesh;
  Index inner_at(int x, int y) const { return static_cast<Index>(outline.vertices.size()) + (x - 1) + (y - 1) * width; }
  int width;  ///< inner vertices in a row
};

/// A rectangle of `columns` by `rows` squares of side 1, each of two triangles.
Grid grid(int columns, int rows) {
  Grid result;
  result.width = columns - 1;
  const auto add = [&](int x, int y, Index boundary) {
    result.outline.vertices.emplace_back(x, y);
    result.outline.boundary_ids.push_back(boundary);
  };
  for (int x = 0; x < columns; ++x) add(x, 0, bottom);
  for (int y = 0; y < rows; ++y) add(columns, y, sides);
  for (int x = columns; x > 0; --x) add(x, rows, top);
  for (int y = rows; y > 0; --y) add(0, y, sides);
  result.outline.loop_start.push_back(result.outline.edge_count());
  result.mesh.vertices = result.outline.vertices;
  for (int y = 1; y < rows; ++y)
    for (int x = 1; x < columns; ++x) result.mesh.vertices.emplace_back(x, y);
  const auto number = [&](int x, int y) -> Index {
    if (y == 0) return x;
    if (x == columns) return columns + y;
    if (y == rows) return columns + rows + (columns - x);
    if (x == 0) return 2 * columns + rows + (rows - y);
    return result.inner_at(x, y);
  };
  for (int y = 0; y < rows; ++y)
    for (int x = 0; x < columns; ++x) {
      result.mesh.triangles.push_back({number(x, y), number(x + 1, y), number(x + 1, y + 1)});
      result.mesh.triangles.push_back({number(x, y), number(x + 1, y + 1), number(x, y + 1)});
    }
  return result;
}

constexpr double poor = 0.3;

TEST(FirstCells, at_the_surface_are_thinner_and_the_next_ones_thicker) {
  const Grid before = grid(6, 6);
  Triangulation after = before.mesh;
  thin_first_cells(before.outline, {true, false, false}, poor, after);
  for (int y = 1; y < 6; ++y)
    for (int x = 1; x < 6; ++x) {
      const Point &old = before.mesh.vertices[before.inner_at(x, y)], &now = after.vertices[before.inner_at(x, y)];
      EXPECT_EQ(now[0], old[0]);
      EXPECT_NEAR(now[1], y == 1 ? 0.7 : y, 1e-15) << x << ", " << y;
    }
  for (std::size_t n = 0; n < before.outline.vertices.size(); ++n)
    EXPECT_EQ(after.vertices[n], before.mesh.vertices[n]);
  EXPECT_EQ(after.triangles, before.mesh.triangles);
}

TEST(FirstCells, stay_where_surface_lies_on_both_sides) {
  const Grid before = grid(6, 2);
  Triangulation after = before.mesh;
  thin_first_cells(before.outline, {true, false, true}, poor, after);
  EXPECT_EQ(after.vertices, before.mesh.vertices);
}

TEST(FirstCells, stay_where_a_triangle_would_become_poor) {
  const Grid before = grid(6, 6);
  Triangulation after = before.mesh;
  thin_first_cells(before.outline, {true, false, false}, 0.95, after);
  EXPECT_EQ(after.vertices, before.mesh.vertices);
}

}  // namespace
}  // namespace parison::remesh
