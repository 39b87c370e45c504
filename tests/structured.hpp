#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "core/mesh/mesh.hpp"

namespace parison::tests {

/// Structured quadratic mesh of the image of the unit square; its sides are the boundaries bottom, right, top, left.
/// `map` is evaluated at all nodes, mid-sides included.
inline core::Mesh structured(core::Index columns, core::Index rows,
                             const std::function<core::Point(double, double)>& map) {
  using core::Index;
  using core::Point;
  std::vector<Point> x;
  std::vector<std::array<Index, 3>> cells;
  for (Index j = 0; j <= rows; ++j)
    for (Index i = 0; i <= columns; ++i) x.push_back({double(i) / columns, double(j) / rows});
  for (Index j = 0; j < rows; ++j)
    for (Index i = 0; i < columns; ++i) {
      const Index a = j * (columns + 1) + i, above = a + columns + 1;
      if ((i + j) % 2 == 0) {
        cells.push_back({a, a + 1, above + 1});
        cells.push_back({a, above + 1, above});
      } else {
        cells.push_back({a, a + 1, above});
        cells.push_back({a + 1, above + 1, above});
      }
    }
  core::Mesh mesh = core::make_quadratic_mesh(x, cells);
  mesh.edit().boundaries = {"bottom", "right", "top", "left"};
  for (auto& edge : mesh.edit().boundary_edges) {
    const Point& m = mesh.nodes[edge.nodes[2]];
    edge.boundary_id = m[1] == 0 ? 0 : m[0] == 1 ? 1 : m[1] == 1 ? 2 : 3;
  }
  for (auto& node : mesh.nodes) node = map(node[0], node[1]);
  return mesh;
}

}  // namespace parison::tests
