// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/film.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "remesh/surface/curve.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

namespace {

/// Largest cosine of the angle between the outward normals of a film's two sides: opposite to within 18 degrees.
constexpr double facing = -0.95;

Point outward_normal(const core::Mesh& mesh, const std::array<Index, 3>& edge, const Point& x) {
  const Point along = tangent(mesh, edge, closest_on(mesh, edge, x));
  return {along[1], -along[0]};
}

}  // namespace

double film_size(double thickness, double min_thickness) {
  constexpr double elements = 4;
  const double thick = 1e-3 / 0.3e-3 * min_thickness;  // 1 mm where the thinnest film is the default of 0.3 mm
  return std::max(thickness, min_thickness) / elements * std::max(1.0, thickness / thick);
}

Eigen::VectorXd film_thickness(const core::Mesh& mesh, const remesh::Wall& wall, const std::vector<bool>& contact) {
  Eigen::VectorXd thickness = Eigen::VectorXd::Constant(mesh.node_count(), std::numeric_limits<double>::infinity());
  if (contact.empty()) return thickness;
  for (Index node = 0; node < mesh.node_count(); ++node) {
    if (wall.far_edge[node] < 0 || !contact[node]) continue;
    const core::BoundaryEdge& other = mesh.boundary_edges()[wall.far_edge[node]];
    const auto touches = [&](Index n) { return contact[n]; };
    const bool mirror = mesh.kind_of(other) == core::BoundaryKind::symmetry;
    if (!mirror && std::none_of(other.nodes.begin(), other.nodes.end(), touches)) continue;
    const Point opposite = mesh.nodes[node] - wall.thickness[node] * wall.normal[node];
    if (outward_normal(mesh, other.nodes, opposite).dot(wall.normal[node]) < facing)
      thickness[node] = wall.thickness[node];
  }
  return thickness;
}

Eigen::VectorXd film_between_tools(const core::Mesh& mesh, const remesh::Wall& wall,
                                   const std::vector<Index>& contact_tool) {
  std::vector<bool> contact(contact_tool.size());
  for (std::size_t n = 0; n < contact.size(); ++n) contact[n] = contact_tool[n] >= 0;
  Eigen::VectorXd thickness = film_thickness(mesh, wall, contact);
  for (Index node = 0; node < thickness.size(); ++node) {
    if (!std::isfinite(thickness[node])) continue;
    const auto& other = mesh.boundary_edges()[wall.far_edge[node]].nodes;
    const auto on_other_tool = [&](Index n) { return contact_tool[n] >= 0 && contact_tool[n] != contact_tool[node]; };
    if (!std::all_of(other.begin(), other.end(), on_other_tool))
      thickness[node] = std::numeric_limits<double>::infinity();
  }
  return thickness;
}

}  // namespace parison::remesh
