// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/outline.hpp"

#include <algorithm>
#include <numeric>
#include <unordered_map>

#include "core/mesh/profile.hpp"
#include "remesh/mesher/quality.hpp"
#include "remesh/mesher/triangulate.hpp"
#include "remesh/surface/curve.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

constexpr double folded = 0.3;         ///< quality of a cell below which its boundary edge is straightened
constexpr double poor = 0.55;          ///< quality of a triangle below which its vertices are smoothed
constexpr double min_depth = 1e-5;     ///< penetration below which a point is left to the finished mesh, m
constexpr int samples = 8;             ///< points along an edge at which penetration is tested
constexpr int penetrating_parts = 32;  ///< parts of an edge that penetrates a tool

/// Two chords for each edge, from its start to the mid point and on to its end.
std::vector<core::Chord> chords(const Outline& outline) {
  const std::vector<Index> ends = edge_ends(outline);
  const Index count = outline.edge_count();
  std::vector<core::Chord> result;
  for (Index i = 0; i < count; ++i) {
    result.push_back({outline.vertices[i], outline.mids[i], i, count + i});
    result.push_back({outline.mids[i], outline.vertices[ends[i]], count + i, ends[i]});
  }
  return result;
}

/// Adds the mid-side nodes, those of the outline first, the cells and the boundary edges. Returns whether every edge of
/// the outline belongs to a triangle.
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

void straighten_folded(Mesh& mesh) {
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    const double curved_quality = cell_quality(mesh, edge.cell);
    if (curved_quality >= folded) continue;
    const auto [first, last, mid] = edge.nodes;
    const Point kept = mesh.nodes[mid];
    mesh.nodes[mid] = 0.5 * (mesh.nodes[first] + mesh.nodes[last]);
    if (cell_quality(mesh, edge.cell) <= curved_quality) mesh.nodes[mid] = kept;
  }
}

}  // namespace

std::vector<Index> edge_ends(const Outline& outline) {
  std::vector<Index> ends(outline.vertices.size());
  std::iota(ends.begin(), ends.end(), 1);
  for (std::size_t k = 0; k + 1 < outline.loop_start.size(); ++k)
    ends[outline.loop_start[k + 1] - 1] = outline.loop_start[k];
  return ends;
}

std::pair<Index, Index> find_crossing(const Outline& outline) {
  const auto [first, second] = core::find_crossing(chords(outline));
  return {first < 0 ? -1 : first / 2, second < 0 ? -1 : second / 2};
}

MeshedOutline mesh_outline(const Outline& outline, const std::vector<core::MeshBoundary>& boundaries,
                           const SizeField& size) {
  Triangulation triangles = triangulate(outline, size);
  if (!triangles.reason.empty()) return {{}, triangles.reason};
  smooth_poor_triangles(outline.vertices.size(), poor, triangles);
  MeshedOutline result;
  Mesh& mesh = result.mesh;
  mesh.nodes = std::move(triangles.vertices);
  mesh.edit().vertex_count = mesh.node_count();
  mesh.edit().boundaries = boundaries;
  if (!add_mid_nodes(outline, triangles, mesh)) return {{}, "the mesher lost edges of the outline"};
  straighten_folded(mesh);
  return result;
}

namespace {

bool penetrates_between(const Mesh& mesh, const ExteriorProjection& project_out, const Place& from, double to) {
  for (int k = 0; project_out && k <= samples; ++k)
    if (penetrates(mesh, project_out, {from.edge, from.s + (to - from.s) * k / samples})) return true;
  return false;
}

}  // namespace

Point exterior_point(const Mesh& mesh, const ExteriorProjection& project_out, const Place& place) {
  const auto& nodes = mesh.boundary_edges()[place.edge].nodes;
  const Point x = place.s == 0 ? mesh.nodes[nodes[0]] : point_on(mesh, nodes, place.s);
  if (!project_out) return x;
  const Point out = project_out(x);
  return (out - x).norm() > min_depth ? out : x;
}

bool penetrates(const Mesh& mesh, const ExteriorProjection& project_out, const Place& place) {
  return exterior_point(mesh, project_out, place) != exterior_point(mesh, {}, place);
}

void extend(const Mesh& mesh, const ExteriorProjection& project_out, const Place& from, double to,
            BoundaryCurve& curve) {
  if (curve.straight || !penetrates_between(mesh, project_out, from, to)) {
    const auto& nodes = mesh.boundary_edges()[from.edge].nodes;
    const double before = from.s > 0 ? arc_length(mesh, nodes, from.s) : 0;
    curve.parts.push_back({from, before, curve.length() + arc_length(mesh, nodes, to) - before, 0});
    return;
  }
  const double span = (to - from.s) / penetrating_parts;
  Place place = from;
  Point start = exterior_point(mesh, project_out, place);
  for (int k = 1; k <= penetrating_parts; ++k) {
    const Place next{from.edge, from.s + k * span};
    const Point end = exterior_point(mesh, project_out, next);
    curve.parts.push_back({place, 0, curve.length() + (end - start).norm(), span});
    place = next, start = end;
  }
}

Place place_at(const Mesh& mesh, const BoundaryCurve& curve, double length) {
  const auto until = [](const CurvePart& part, double value) { return part.until < value; };
  const auto found = std::lower_bound(curve.parts.begin(), curve.parts.end() - 1, length, until);
  const double start = found == curve.parts.begin() ? 0 : (found - 1)->until, ahead = length - start;
  const auto [edge, s] = found->from;
  if (found->span > 0) return {edge, s + (ahead > 0 ? ahead / (found->until - start) * found->span : 0)};
  return {edge, at_arc_length(mesh, mesh.boundary_edges()[edge].nodes, ahead + found->before)};
}

}  // namespace parison::remesh
