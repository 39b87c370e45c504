// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/remeshing/named_boundary.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "contact/unilateral/tool_gap.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {
namespace {

/// The contact edge whose start (end 0) or end (end 1) is nearest to x. For a place on the axis that is an end on the
/// axis, also where the surface beside it is nearer.
struct NearestEdge {
  std::size_t edge = 0;
  double distance = std::numeric_limits<double>::infinity();
};
NearestEdge nearest_edge(core::Geometry geometry, const core::Mesh& mesh, const Point& x, int end) {
  const auto may_touch = core::boundaries_of_kind(mesh, BoundaryKind::contact);
  const bool is_on_axis = geometry == core::Geometry::axisymmetric && x[0] == 0;
  NearestEdge nearest, on_axis;
  for (std::size_t e = 0; e < mesh.boundary_edges().size(); ++e) {
    if (!may_touch[mesh.boundary_edges()[e].boundary_id]) continue;
    const Point& at = mesh.nodes[mesh.boundary_edges()[e].nodes[end]];
    const double d = (at - x).norm();
    if (d < nearest.distance) nearest = {e, d};
    if (is_on_axis && at[0] == 0 && d < on_axis.distance) on_axis = {e, d};
  }
  return std::isfinite(on_axis.distance) ? on_axis : nearest;
}

/// By boundary edge whether it lies on a tool: its ends press on it or have no gap to it.
std::vector<bool> edges_on_tool(const Scene& scene, const State& state, Index tool) {
  const core::Mesh& mesh = state.glass.mesh;
  const double touching = core::tolerance::contact_after_remesh * core::size(scene.glass.profile);
  const std::vector<bool> contact = contact_boundaries(scene.tools[tool]);
  const contact::ToolGap gap(scene.tools[tool].profile, contact, 2 * touching);
  const Point offset = state.tools[tool].offset * core::axis_direction();
  const auto touches = [&](Index node) {
    return state.glass.contact_tool[node] == tool || gap(mesh.nodes[node] - offset) < touching;
  };
  std::vector<bool> on_tool;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    on_tool.push_back(mesh.kind_of(edge) == BoundaryKind::contact && touches(edge.nodes[0]) && touches(edge.nodes[1]));
  return on_tool;
}

/// Whether an edge parts what a tool made: no contact boundary, or held by other tools alone.
bool parts(const core::Mesh& mesh, const State& state, Index tool, const core::BoundaryEdge& edge) {
  if (mesh.kind_of(edge) != BoundaryKind::contact) return true;
  const Index a = state.glass.contact_tool[edge.nodes[0]], b = state.glass.contact_tool[edge.nodes[1]];
  return a >= 0 && b >= 0 && a != tool && b != tool;
}

/// The longest stretch of the surface from the first to the last edge on a tool; where it has come off in between, the
/// stretch goes on unless another tool or a symmetry boundary parts it. As edges in their order, empty without any.
std::vector<std::size_t> touched_edges(const Scene& scene, const State& state, Index tool) {
  const core::Mesh& mesh = state.glass.mesh;
  const auto& edges = mesh.boundary_edges();
  const std::vector<bool> on_tool = edges_on_tool(scene, state, tool);
  const auto is_part = [&](std::size_t e) { return !on_tool[e] && parts(mesh, state, tool, edges[e]); };
  std::size_t start = 0;
  while (start < edges.size() && !is_part(start)) ++start;
  std::vector<std::size_t> best, present, pending;
  double best_length = 0, length = 0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::size_t e = (start + i) % edges.size(), before = (e + edges.size() - 1) % edges.size();
    if (is_part(e) || edges[before].nodes[1] != edges[e].nodes[0]) present.clear(), pending.clear(), length = 0;
    if (is_part(e) || (present.empty() && !on_tool[e])) continue;
    pending.push_back(e);
    if (!on_tool[e]) continue;
    present.insert(present.end(), pending.begin(), pending.end());
    pending.clear();
    length += (mesh.nodes[edges[e].nodes[1]] - mesh.nodes[edges[e].nodes[0]]).norm();
    if (length > best_length) best = present, best_length = length;
  }
  return best;
}

/// Gaps to tools up to this, m, let no air through, as `seal_gap` does by default.
constexpr double sealed_gap = 0.1e-3;

/// By boundary edge whether air reaches it: it may touch and does not lie, within the sealed gap, on a tool other than
/// the one that made the inner side.
std::vector<bool> open_edges(const Scene& scene, const State& state, Index maker) {
  const core::Mesh& mesh = state.glass.mesh;
  std::vector<bool> sealed(mesh.nodes.size(), false);
  for (const StageTool& placed : scene.stages[state.stage].tools) {
    if (placed.tool == maker) continue;
    const Eigen::VectorXd gaps = tool_gaps(scene, state, placed.tool, 2 * sealed_gap);
    for (Index n = 0; n < mesh.node_count(); ++n)
      if (gaps[n] <= sealed_gap || state.glass.contact_tool[n] == placed.tool) sealed[n] = true;
  }
  std::vector<bool> open;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    open.push_back(mesh.kind_of(edge) == BoundaryKind::contact && !(sealed[edge.nodes[0]] && sealed[edge.nodes[1]]));
  return open;
}

/// Edges in their order, with those beside them that the air in the cavity reaches, up to where other tools seal it;
/// not on a side on which the surface ends before.
std::vector<std::size_t> with_open_ends(const Scene& scene, const State& state, Index maker,
                                        std::vector<std::size_t> edges) {
  const auto& all = state.glass.mesh.boundary_edges();
  const std::vector<bool> open = open_edges(scene, state, maker);
  const auto beside = [&](std::size_t e, bool ahead) { return (e + (ahead ? 1 : all.size() - 1)) % all.size(); };
  const auto joined = [&](std::size_t a, std::size_t b) { return all[a].nodes[1] == all[b].nodes[0]; };
  for (const bool ahead : {false, true}) {
    std::vector<std::size_t> more;
    std::size_t last = ahead ? edges.back() : edges.front(), next = beside(last, ahead);
    while (open[next] && more.size() < all.size() && (ahead ? joined(last, next) : joined(next, last))) {
      more.push_back(next);
      last = next, next = beside(next, ahead);
    }
    const bool seals = state.glass.mesh.kind_of(all[next]) == BoundaryKind::contact && !open[next];
    if (seals) edges.insert(ahead ? edges.end() : edges.begin(), more.begin(), more.end());
    if (seals && !ahead) std::reverse(edges.begin(), edges.begin() + std::ptrdiff_t(more.size()));
  }
  return edges;
}

/// The edges that a tool touched; of the inner side also those that the air in the cavity reaches beside them.
std::vector<std::size_t> edges_of(const Scene& scene, const State& state, const NamedBoundary& named) {
  const std::vector<std::size_t> touched = touched_edges(scene, state, *named.touched);
  return named.name != inner_side || touched.empty() ? touched : with_open_ends(scene, state, *named.touched, touched);
}

void name_between(core::Geometry geometry, const NamedBoundary& named, Index boundary_id, core::Mesh& mesh) {
  const auto may_touch = core::boundaries_of_kind(mesh, BoundaryKind::contact);
  const std::size_t last = nearest_edge(geometry, mesh, named.to, 1).edge;
  for (std::size_t e = nearest_edge(geometry, mesh, named.from, 0).edge;; e = (e + 1) % mesh.boundary_edges().size()) {
    if (mesh.boundary_edges()[e].boundary_id != boundary_id && may_touch[mesh.boundary_edges()[e].boundary_id])
      mesh.edit().boundary_edges[e].boundary_id = boundary_id;
    if (e == last) break;
  }
}

}  // namespace

void name_boundary(const Scene& scene, const State& state, const NamedBoundary& named, core::Mesh& mesh) {
  Index boundary_id = core::find_boundary(mesh, named.name);
  if (boundary_id < 0) {
    boundary_id = static_cast<Index>(mesh.boundaries().size());
    mesh.edit().boundaries.push_back(named.name);
  }
  if (!named.touched) return name_between(scene.geometry, named, boundary_id, mesh);
  for (const std::size_t e : edges_of(scene, state, named)) mesh.edit().boundary_edges[e].boundary_id = boundary_id;
}

std::string misplaced_boundary(const Scene& scene, const State& state, Index stage) {
  const core::Mesh& mesh = state.glass.mesh;
  const double max_end_distance = core::tolerance::named_end * core::size(scene.glass.profile);
  for (const auto& named : scene.stages[stage].named_boundaries) {
    if (named.touched) {
      if (!touched_edges(scene, state, *named.touched).empty()) continue;
      return fmt::format("name_boundary {}: no glass touches \"{}\" at the end of the stage before", named.name,
                         scene.tools[*named.touched].name);
    }
    for (const int end : {0, 1}) {
      const Point& x = end == 0 ? named.from : named.to;
      const auto nearest = nearest_edge(scene.geometry, mesh, x, end);
      if (nearest.distance <= max_end_distance) continue;
      const Point& found = mesh.nodes[mesh.boundary_edges()[nearest.edge].nodes[end]];
      return fmt::format(
          "name_boundary {}: \"{}\", ({:.4g}, {:.4g}) mm, lies {:.3g} mm from the surface of the glass, nearest to "
          "({:.4g}, {:.4g}) mm; "
          "allowed are {:g} mm",
          named.name, end == 0 ? "from" : "to", 1e3 * x[0], 1e3 * x[1], 1e3 * nearest.distance, 1e3 * found[0],
          1e3 * found[1], 1e3 * max_end_distance);
    }
  }
  return "";
}

}  // namespace parison::forming
