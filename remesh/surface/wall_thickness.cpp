// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/wall_thickness.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>
#include <utility>

#include "core/math/numbers.hpp"
#include "remesh/mesher/fans.hpp"
#include "remesh/surface/boundary_rays.hpp"
#include "remesh/surface/curve.hpp"

namespace parison::remesh {

namespace {

/// Boundaries, one flag for each, behind which a body goes on as its mirror image.
using Mirrors = std::vector<bool>;

Mirrors passing_no_heat(const Mesh& mesh) {
  Mirrors mirrors;
  for (const core::MeshBoundary& boundary : mesh.boundaries())
    mirrors.push_back(boundary.kind == core::BoundaryKind::symmetry || boundary.kind == core::BoundaryKind::insulated ||
                      boundary.kind == core::BoundaryKind::fixed);
  return mirrors;
}

/// For each vertex the nearest node with a finite value, found by a front that advances from vertex to vertex in the
/// order of distance (E. W. Dijkstra, Numer. Math. 1 (1959) 269-271); -1 without such a node.
std::vector<Index> sources_of_vertices(const Mesh& mesh, const Eigen::VectorXd& value) {
  struct Front {
    double distance;  ///< squared
    Index vertex, source;
    bool operator>(const Front& other) const {
      return std::tie(distance, vertex) > std::tie(other.distance, other.vertex);
    }
  };
  std::vector<double> reached(mesh.vertex_count(), core::infinity);
  std::vector<Index> source(mesh.vertex_count(), -1);
  const auto reach = [&](Index vertex, Index from) {
    const double distance = (mesh.nodes[vertex] - mesh.nodes[from]).squaredNorm();
    const bool nearer = distance < reached[vertex];
    if (nearer) reached[vertex] = distance, source[vertex] = from;
    return nearer;
  };
  for (const auto& cell : mesh.cells())
    for (const Index node : cell)
      if (std::isfinite(value[node]))
        for (int i = 0; i < 3; ++i) reach(cell[i], node);
  std::vector<Front> first;
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (source[v] >= 0) first.push_back({reached[v], v, source[v]});
  std::priority_queue<Front, std::vector<Front>, std::greater<>> fronts(std::greater<>(), std::move(first));
  const Fans fans = fans_of(mesh);
  while (!fronts.empty()) {
    const Front front = fronts.top();
    fronts.pop();
    if (front.source != source[front.vertex]) continue;
    for (Index k = fans.start[front.vertex]; k < fans.start[front.vertex + 1]; ++k)
      for (int i = 0; i < 3; ++i) {
        const Index vertex = mesh.cells()[fans.cell[k]][i];
        if (source[vertex] != front.source && reach(vertex, front.source))
          fronts.push({reached[vertex], vertex, front.source});
      }
  }
  return source;
}

}  // namespace

void spread_inward(const Mesh& mesh, Eigen::VectorXd& value) {
  std::vector<Index> source = sources_of_vertices(mesh, value);
  source.resize(mesh.nodes.size(), -1);
  for (const auto& cell : mesh.cells())
    for (int i = 0; i < 3; ++i) {  // a mid-side node takes the nearer of its ends' sources
      const Index node = cell[3 + i], a = source[cell[i]], b = source[cell[(i + 1) % 3]];
      if (a < 0 || b < 0) continue;
      const double from_a = (mesh.nodes[node] - mesh.nodes[a]).squaredNorm();
      const double from_b = (mesh.nodes[node] - mesh.nodes[b]).squaredNorm();
      source[node] = std::tie(from_a, a) < std::tie(from_b, b) ? a : b;
    }
  for (Index i = 0; i < mesh.node_count(); ++i)
    if (!std::isfinite(value[i]) && source[i] >= 0) value[i] = value[source[i]];
}

namespace {

Wall wall_between(const Mesh& mesh, double reach, const Mirrors& mirrors, const std::vector<bool>& only = {}) {
  const BoundaryRays rays(mesh);
  Mirrors open = mirrors;
  open.flip();
  Wall wall{Eigen::VectorXd::Constant(mesh.node_count(), core::infinity), std::vector<Index>(mesh.nodes.size(), -1),
            normal_sums(mesh, open)};
  constexpr double likely = 1.5;  // times the thickness beside: a node's own is no greater as a rule
  double beside = core::infinity;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    for (const Index node : edge.nodes) {
      if (!only.empty() && !only[node]) continue;
      if (mirrors[edge.boundary_id] || wall.far_edge[node] >= 0 || wall.normal[node].norm() < 1e-6) continue;
      wall.normal[node].normalize();
      const BoundaryRays::Hit hit =
          rays.first_exit({mesh.nodes[node], -wall.normal[node], node}, reach, likely * beside);
      if (hit.edge < 0) continue;
      beside = hit.distance;
      wall.far_edge[node] = hit.edge;
      wall.thickness[node] = (mirrors[mesh.boundary_edges()[hit.edge].boundary_id] ? 2 : 1) * hit.distance;
    }
  }
  return wall;
}

}  // namespace

Wall surface_wall(const Mesh& mesh, double reach, const std::vector<bool>& only) {
  return wall_between(mesh, reach, core::boundaries_of_kind(mesh, core::BoundaryKind::symmetry), only);
}

Eigen::VectorXd wall_thickness(const Mesh& mesh) {
  Eigen::VectorXd thickness = wall_between(mesh, core::infinity, passing_no_heat(mesh)).thickness;
  spread_inward(mesh, thickness);
  return thickness;
}

}  // namespace parison::remesh
