#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::tests {

/// Quarter of the section of a sphere, `rings` rings of cells; an even number has nodes at half the radius. Boundaries:
/// surface, axes.
inline core::Mesh quarter_sphere(double radius, int rings) {
  using core::Index;
  using core::Point;
  std::vector<Point> vertices{Point::Zero()};
  std::vector<std::array<Index, 3>> cells;
  const auto at = [&](int ring, int i) { return ring == 0 ? 0 : 1 + Index(ring - 1) * (2 * rings + 1) + i; };
  const int sectors = 2 * rings;
  for (int ring = 1; ring <= rings; ++ring)
    for (int i = 0; i <= sectors; ++i) {
      const double angle = M_PI / 2 * i / sectors, r = radius * ring / rings;
      vertices.emplace_back(i == sectors ? 0 : r * std::cos(angle), i == 0 ? 0 : r * std::sin(angle));
    }
  for (int i = 0; i < sectors; ++i) cells.push_back({0, at(1, i), at(1, i + 1)});
  for (int ring = 1; ring < rings; ++ring)
    for (int i = 0; i < sectors; ++i) {
      cells.push_back({at(ring, i), at(ring + 1, i), at(ring + 1, i + 1)});
      cells.push_back({at(ring, i), at(ring + 1, i + 1), at(ring, i + 1)});
    }
  core::Mesh mesh = core::make_quadratic_mesh(vertices, cells);
  for (const auto& cell : mesh.cells())  // edges along rings are arcs
    for (int k = 0; k < 3; ++k) {
      const double a = mesh.nodes[cell[k]].norm(), b = mesh.nodes[cell[(k + 1) % 3]].norm();
      if (std::abs(a - b) < 1e-9 * radius) mesh.nodes[cell[3 + k]] *= a / mesh.nodes[cell[3 + k]].norm();
    }
  auto& topology = mesh.edit();
  topology.boundaries = {{"surface", core::BoundaryKind::air}, {"axes", core::BoundaryKind::symmetry}};
  for (auto& edge : topology.boundary_edges) {
    const Point middle = mesh.nodes[edge.nodes[2]];
    edge.boundary_id = std::min(middle[0], middle[1]) < 1e-9 * radius ? 1 : 0;
  }
  return mesh;
}

}  // namespace parison::tests
