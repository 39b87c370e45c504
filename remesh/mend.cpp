// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "remesh/triangulate.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

double straight_quality(const Triangulation& mesh, const std::array<Index, 3>& corner) {
  const Point &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
  const Point u = b - a, v = c - a;
  const double sides = u.squaredNorm() + v.squaredNorm() + (c - b).squaredNorm();
  return 2 * std::sqrt(3.0) * (u[0] * v[1] - u[1] * v[0]) / sides;
}

}  // namespace

void mend_poor(std::size_t fixed, double poor, Triangulation& mesh) {
  constexpr int sweeps = 2;
  std::vector<std::vector<std::size_t>> round(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Index corner : mesh.triangles[t]) round[corner].push_back(t);
  const auto worst = [&](std::size_t vertex) {
    double least = 1;
    for (const std::size_t t : round[vertex]) least = std::min(least, straight_quality(mesh, mesh.triangles[t]));
    return least;
  };
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t vertex = fixed; vertex < mesh.vertices.size(); ++vertex) {
      const double before = worst(vertex);
      if (before >= poor || round[vertex].empty()) continue;
      const Point kept = mesh.vertices[vertex];
      Point sum = Point::Zero();
      for (const std::size_t t : round[vertex])
        for (const Index corner : mesh.triangles[t]) sum += mesh.vertices[corner];
      const double triangles = static_cast<double>(round[vertex].size());
      mesh.vertices[vertex] = (sum - triangles * kept) / (2 * triangles);
      if (worst(vertex) <= before) mesh.vertices[vertex] = kept;
    }
}

}  // namespace parison::remesh
