// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/symmetry_planes.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace parison::forming {

using core::Point;

namespace {

struct Plane {
  Point at, inward;
};

/// The planes of symmetry, each once. Boundary edges have the glass on their left.
std::vector<Plane> symmetry_planes(core::Geometry geometry, const core::Mesh& mesh) {
  constexpr double same = 1e-6;  // of an angle, and of the length of an edge
  std::vector<Plane> planes;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) != core::BoundaryKind::symmetry) continue;
    const Point &first = mesh.nodes[edge.nodes[0]], along = mesh.nodes[edge.nodes[1]] - first;
    const Point inward = Point(-along[1], along[0]).normalized();
    const bool on_axis = geometry == core::Geometry::axisymmetric && std::abs(inward[0]) > std::abs(inward[1]);
    const auto is_same = [&](const Plane& other) {
      return inward.dot(other.inward) > 1 - same && std::abs(other.inward.dot(first - other.at)) < same * along.norm();
    };
    if (!on_axis && std::none_of(planes.begin(), planes.end(), is_same)) planes.push_back({first, inward});
  }
  return planes;
}

}  // namespace

double depth_beyond_symmetry_planes(core::Geometry geometry, const core::Mesh& mesh) {
  double depth = 0;
  for (const Plane& plane : symmetry_planes(geometry, mesh))
    for (const core::BoundaryEdge& edge : mesh.boundary_edges())
      depth = std::max(depth, plane.inward.dot(plane.at - mesh.nodes[edge.nodes[0]]));
  return depth;
}

}  // namespace parison::forming
