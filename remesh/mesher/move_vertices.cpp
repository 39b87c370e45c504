// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "remesh/mesher/triangulate.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

/// Distance of a vertex beside the surface that is kept. A half-space of quadratic cells that is chilled: 0.7 takes the
/// error of its heat at times of 0.03 to 0.1 of height^2 / diffusivity to a half or less, and leaves 0.1 % later on;
/// 0.5 costs 0.5 % at 0.3.
constexpr double first_height = 0.7;

double straight_quality(const Triangulation& mesh, const std::array<Index, 3>& corner) {
  const Point &a = mesh.vertices[corner[0]], &b = mesh.vertices[corner[1]], &c = mesh.vertices[corner[2]];
  const Point u = b - a, v = c - a;
  const double sides = u.squaredNorm() + v.squaredNorm() + (c - b).squaredNorm();
  return 2 * std::sqrt(3.0) * (u[0] * v[1] - u[1] * v[0]) / sides;
}

/// The triangles round each vertex.
using Rounds = std::vector<std::vector<std::size_t>>;

Rounds rounds_of(const Triangulation& mesh) {
  Rounds round(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Index corner : mesh.triangles[t]) round[corner].push_back(t);
  return round;
}

double min_quality_round(const Triangulation& mesh, const std::vector<std::size_t>& round) {
  double least = 1;
  for (const std::size_t t : round) least = std::min(least, straight_quality(mesh, mesh.triangles[t]));
  return least;
}

/// The edges of the surface at each vertex of an outline.
std::vector<std::vector<std::pair<Index, Index>>> edges_at(const Outline& outline,
                                                           const std::vector<bool>& in_surface) {
  const std::vector<Index> ends = edge_ends(outline);
  std::vector<std::vector<std::pair<Index, Index>>> edges(outline.vertices.size());
  for (Index i = 0; i < outline.edge_count(); ++i) {
    if (!in_surface.at(outline.boundary_ids[i])) continue;
    edges[i].push_back({i, ends[i]});
    edges[ends[i]].push_back({i, ends[i]});
  }
  return edges;
}

/// The point of a straight line nearest to x.
Point nearest_on(const Point& from, const Point& to, const Point& x) {
  const Point along = to - from;
  return from + std::clamp((x - from).dot(along) / along.squaredNorm(), 0.0, 1.0) * along;
}

/// The shortest of some ways to a surface, m; shorter, down to nothing, the more the surface also lies elsewhere, as in
/// a corner or a thin wall. It changes continuously with the ways.
Point towards_surface(const std::vector<Point>& ways) {
  const Point nearest =
      *std::min_element(ways.begin(), ways.end(), [](const Point& a, const Point& b) { return a.norm() < b.norm(); });
  double elsewhere = 0;  // 1 as near on the other side, 1/2 as near at a right angle
  for (const Point& way : ways) {
    const double nearness = nearest.norm() / way.norm();
    const double cosine = way.dot(nearest) / (way.norm() * nearest.norm());
    elsewhere = std::max(elsewhere, 0.5 * (1 - cosine) * nearness * nearness);
  }
  constexpr double beside = 0.1, corner = 0.5;  // of a flat surface, of a corner of 90 degrees
  return std::clamp((corner - elsewhere) / (corner - beside), 0.0, 1.0) * nearest;
}

}  // namespace

void smooth_poor_triangles(std::size_t fixed, double poor, Triangulation& mesh) {
  constexpr int sweeps = 2;
  const Rounds round = rounds_of(mesh);
  for (int sweep = 0; sweep < sweeps; ++sweep)
    for (std::size_t vertex = fixed; vertex < mesh.vertices.size(); ++vertex) {
      const double before = min_quality_round(mesh, round[vertex]);
      if (before >= poor || round[vertex].empty()) continue;
      const Point kept = mesh.vertices[vertex];
      Point sum = Point::Zero();
      for (const std::size_t t : round[vertex])
        for (const Index corner : mesh.triangles[t]) sum += mesh.vertices[corner];
      const double triangles = static_cast<double>(round[vertex].size());
      mesh.vertices[vertex] = (sum - triangles * kept) / (2 * triangles);
      if (min_quality_round(mesh, round[vertex]) <= before) mesh.vertices[vertex] = kept;
    }
}

void thin_first_cells(const Outline& outline, const std::vector<bool>& in_surface, double poor, Triangulation& mesh) {
  const auto edges = edges_at(outline, in_surface);
  const Rounds round = rounds_of(mesh);
  const std::size_t fixed = outline.vertices.size();
  for (std::size_t vertex = fixed; vertex < mesh.vertices.size(); ++vertex) {
    const Point x = mesh.vertices[vertex];
    std::vector<Point> ways;
    for (const std::size_t t : round[vertex])
      for (const Index corner : mesh.triangles[t])
        if (static_cast<std::size_t>(corner) < fixed)
          for (const auto& [from, to] : edges[corner])
            ways.push_back(nearest_on(mesh.vertices[from], mesh.vertices[to], x) - x);
    if (ways.empty()) continue;
    mesh.vertices[vertex] = x + (1 - first_height) * towards_surface(ways);
    if (min_quality_round(mesh, round[vertex]) < poor) mesh.vertices[vertex] = x;
  }
}

}  // namespace parison::remesh
