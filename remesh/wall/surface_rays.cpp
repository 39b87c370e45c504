// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/wall/surface_rays.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/math/numbers.hpp"
#include "remesh/surface/boundary_rays.hpp"
#include "remesh/surface/curve.hpp"

namespace parison::remesh {
namespace {

/// Rays that meet an edge at less than this, as a sine, run along it.
constexpr double grazing = 1e-6;
/// A ray across the axis at a greater angle to it, by its cosine, goes through a rod.
constexpr double along_axis = 0.5;
constexpr int most_reflections = 4;

using EdgeNodes = std::array<Index, 3>;

Point mirrored(const Point& vector, const Point& normal) {
  return vector - 2 * vector.dot(normal) * normal;
}

bool on_axis(const core::Mesh& mesh, core::Geometry geometry, Index edge) {
  if (geometry != core::Geometry::axisymmetric) return false;
  const EdgeNodes& nodes = mesh.boundary_edges()[edge].nodes;
  const Point &first = mesh.nodes[nodes[0]], &last = mesh.nodes[nodes[1]];
  return std::max(std::abs(first[0]), std::abs(last[0])) < grazing * (last - first).norm();
}

Point middle_of(const std::vector<Point>& corners, double length) {
  double left = 0.5 * length;
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    const double part = (corners[i + 1] - corners[i]).norm();
    if (part >= left) return corners[i] + left / part * (corners[i + 1] - corners[i]);
    left -= part;
  }
  return corners.back();
}

Ray ray_from(const core::Mesh& mesh, const BoundaryRays& exits, core::Geometry geometry,
             const std::vector<bool>& symmetry, Index node, const Point& inward) {
  Ray ray;
  ray.start = mesh.nodes[node];
  ray.direction = inward;
  std::vector<Point> corners{ray.start};
  Point direction = inward;
  double length = 0;
  for (Index from = node, skipped = -1; ray.reflections <= most_reflections; from = -1, ++ray.reflections) {
    const auto hit = exits.first_exit({corners.back(), direction, from, skipped});
    if (hit.edge < 0) return ray;
    const core::BoundaryEdge& edge = mesh.boundary_edges()[hit.edge];
    const Point normal = outward_normal(mesh, edge.nodes, hit.position);
    corners.push_back(point_on(mesh, edge.nodes, hit.position));
    length += hit.distance;
    if (!symmetry[edge.boundary_id]) {
      ray.length = length;
      ray.end = corners.back();
      ray.middle = middle_of(corners, length);
      ray.edge = hit.edge;
      ray.position = hit.position;
      ray.facing = direction.dot(normal);
      return ray;
    }
    if (on_axis(mesh, geometry, hit.edge) && std::abs(direction.dot(core::axis_direction())) < along_axis) return ray;
    direction = mirrored(direction, normal);
    skipped = hit.edge;
  }
  return ray;
}

/// Outward unit normal at each surface node, the mean of those of the edges that meet there and, on a symmetry
/// boundary, of their mirror images; zero at other nodes.
std::vector<Point> node_normals(const core::Mesh& mesh, const std::vector<bool>& symmetry) {
  std::vector<bool> counts = symmetry;
  counts.flip();
  std::vector<Point> normals = normal_sums(mesh, counts);
  constexpr std::array<double, 3> positions{0, 1, 0.5};
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    for (int k = 0; k < 3 && symmetry[edge.boundary_id]; ++k) {
      Point& normal = normals[edge.nodes[k]];
      const Point across = outward_normal(mesh, edge.nodes, positions[k]);
      normal -= normal.dot(across) * across;
    }
  for (Point& normal : normals)
    if (normal.norm() > grazing) normal.normalize();
  return normals;
}

}  // namespace

std::vector<Ray> surface_rays(const core::Mesh& mesh, core::Geometry geometry) {
  const std::vector<bool> symmetry = core::boundaries_of_kind(mesh, core::BoundaryKind::symmetry);
  const std::vector<Point> normals = node_normals(mesh, symmetry);
  const BoundaryRays exits(mesh, grazing);
  std::vector<Ray> rays(mesh.nodes.size());
  std::vector<bool> done(mesh.nodes.size(), false);
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    for (const Index node : edge.nodes) {
      if (symmetry[edge.boundary_id] || done[node] || normals[node].norm() < 0.5) continue;
      rays[node] = ray_from(mesh, exits, geometry, symmetry, node, -normals[node]);
      done[node] = true;
    }
  return rays;
}

double distance_to_edges(const core::Mesh& mesh, const std::vector<bool>& wanted_edges, const Point& x) {
  const auto squared_to_chord = [&](Index from, Index to) {
    const Point& a = mesh.nodes[from];
    const Point chord = mesh.nodes[to] - a;
    const double along = (x - a).dot(chord) / std::max(chord.squaredNorm(), 1e-300);
    return (x - a - std::clamp(along, 0.0, 1.0) * chord).squaredNorm();
  };
  double nearest = core::infinity;
  for (std::size_t edge = 0; edge < wanted_edges.size(); ++edge) {
    if (!wanted_edges[edge]) continue;
    const auto& [first, last, mid] = mesh.boundary_edges()[edge].nodes;
    nearest = std::min({nearest, squared_to_chord(first, mid), squared_to_chord(mid, last)});
  }
  return std::sqrt(nearest);
}

}  // namespace parison::remesh
