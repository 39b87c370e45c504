// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/mesher/mesh_outline.hpp"

#include <algorithm>
#include <cstdint>
#include <unordered_map>

#include "remesh/mesher/quality.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

constexpr double straighten_below = 0.3;  ///< quality below which a straight edge is tried
constexpr double poor = 0.55;             ///< quality below which corners move

/// Numbers the mid-side nodes, those of the outline first, and gives the inner ones their positions.
bool add_mid_nodes(const Outline& outline, const Triangulation& triangles, Mesh& mesh) {
  const auto key = [](Index a, Index b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
  };
  std::unordered_map<std::uint64_t, Index> mid;
  mid.reserve(2 * triangles.triangles.size());
  const std::vector<Index> ends = edge_ends(outline);
  for (Index i = 0; i < outline.edge_count(); ++i) {
    mid[key(i, ends[i])] = mesh.node_count();
    mesh.nodes.push_back(outline.mids[i]);
    mesh.edit().boundary_edges.push_back({{i, ends[i], mesh.node_count() - 1}, -1, outline.boundary_ids[i]});
  }
  for (const auto& corner : triangles.triangles) {
    std::array<Index, 6> cell{corner[0], corner[1], corner[2], -1, -1, -1};
    for (int k = 0; k < 3; ++k) {
      const Index a = corner[k], b = corner[(k + 1) % 3];
      const auto [place, is_new] = mid.try_emplace(key(a, b), mesh.node_count());
      if (is_new) mesh.nodes.push_back(0.5 * (mesh.nodes[a] + mesh.nodes[b]));
      cell[3 + k] = place->second;
      const Index edge = place->second - mesh.vertex_count();
      if (edge < outline.edge_count()) mesh.edit().boundary_edges[edge].cell = mesh.cell_count();
    }
    mesh.edit().cells.push_back(cell);
  }
  return std::all_of(mesh.boundary_edges().begin(), mesh.boundary_edges().end(),
                     [](const auto& edge) { return edge.cell >= 0; });
}

void straighten_inverted(Mesh& mesh) {
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    const double curved_quality = cell_quality(mesh, edge.cell);
    if (curved_quality >= straighten_below) continue;
    const auto [first, last, mid] = edge.nodes;
    const Point kept = mesh.nodes[mid];
    mesh.nodes[mid] = 0.5 * (mesh.nodes[first] + mesh.nodes[last]);
    if (cell_quality(mesh, edge.cell) <= curved_quality) mesh.nodes[mid] = kept;
  }
}

std::vector<bool> in_surface(const std::vector<core::MeshBoundary>& boundaries) {
  std::vector<bool> result;
  for (const core::MeshBoundary& boundary : boundaries) result.push_back(boundary.kind != core::BoundaryKind::symmetry);
  return result;
}

}  // namespace

MeshedOutline mesh_outline(const Outline& outline, const std::vector<core::MeshBoundary>& boundaries,
                           const SizeField& size, const Mesher& mesher, bool has_skin) {
  Triangulation triangles = mesher(outline, size);
  if (!triangles.reason.empty()) return {{}, triangles.reason};
  smooth_poor_triangles(outline.vertices.size(), poor, triangles);
  if (has_skin) thin_first_cells(outline, in_surface(boundaries), straighten_below, triangles);
  MeshedOutline result;
  Mesh& mesh = result.mesh;
  mesh.nodes = std::move(triangles.vertices);
  mesh.edit().vertex_count = mesh.node_count();
  mesh.edit().boundaries = boundaries;
  if (!add_mid_nodes(outline, triangles, mesh)) return {{}, "the mesher lost edges of the outline"};
  straighten_inverted(mesh);
  return result;
}

}  // namespace parison::remesh
