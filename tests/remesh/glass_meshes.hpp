#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of gobs and cups, and the criteria of new ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>

#include "remesh/mesher/mesh_profile.hpp"
#include "remesh/remesh_glass.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

inline constexpr double none = std::numeric_limits<double>::infinity();

inline Mesh meshed(const core::Profile& profile, double size) {
  return mesh_profile(profile, {size, size, 0.3, std::vector<bool>(profile.boundary_names.size(), false)});
}

inline Mesh deformed(Mesh mesh, const std::function<Point(const Point&)>& map) {
  for (Point& x : mesh.nodes) x = map(x);
  return mesh;
}

inline Criteria criteria_for(const Mesh& mesh, double surface_size) {
  Criteria criteria{core::Geometry::axisymmetric, surface_size, 0.1e-3, 4, 0.3, 0.05e-3, {}, {}, {}, {}};
  for (const auto& boundary : mesh.boundaries()) criteria.straight_boundaries.push_back(boundary.name == "axis");
  criteria.contact.assign(mesh.nodes.size(), false);
  criteria.target_skin_size.assign(mesh.nodes.size(), none);
  return criteria;
}

/// Points where the boundary changes its boundary, in order.
inline std::vector<Point> boundary_ends(const Mesh& mesh) {
  std::vector<Point> ends;
  for (std::size_t i = 0; i < mesh.boundary_edges().size(); ++i)
    if (mesh.boundary_edges()[i].boundary_id !=
        mesh.boundary_edges()[(i + mesh.boundary_edges().size() - 1) % mesh.boundary_edges().size()].boundary_id)
      ends.push_back(mesh.nodes[mesh.boundary_edges()[i].nodes[0]]);
  std::sort(ends.begin(), ends.end(), [](const Point& a, const Point& b) { return a[0] + 2 * a[1] < b[0] + 2 * b[1]; });
  return ends;
}

}  // namespace parison::remesh
