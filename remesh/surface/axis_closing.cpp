// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/axis_closing.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "remesh/surface/curve.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

bool lies_on_axis(const Mesh& mesh, const core::BoundaryEdge& edge) {
  return mesh.kind_of(edge) == core::BoundaryKind::symmetry &&
         std::all_of(edge.nodes.begin(), edge.nodes.end(), [&](Index n) { return mesh.nodes[n][0] == 0; });
}

/// Volume between an edge and the axis, m3, with the sign of its direction; two chords.
double volume_to_axis(const Mesh& mesh, const core::BoundaryEdge& edge) {
  const auto frustum = [](const Point& a, const Point& b) {
    return M_PI / 3 * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) * (b[1] - a[1]);
  };
  const auto& [first, last, middle] = edge.nodes;
  return frustum(mesh.nodes[first], mesh.nodes[middle]) + frustum(mesh.nodes[middle], mesh.nodes[last]);
}

/// The free surface from one end of the axis, edge by edge away from it.
struct Chain {
  Index axis_edge;  ///< the last one of the axis
  bool forward;     ///< whether it follows that edge in the order of the boundary
  std::vector<Index> edges;

  /// The node of an edge that is nearer to the end of the axis (0), or farther away (1).
  Index node(const Mesh& mesh, Index edge, int end) const {
    return mesh.boundary_edges()[edge].nodes[forward ? end : 1 - end];
  }
};

std::vector<Chain> chains_from_axis(const Mesh& mesh) {
  const std::vector<Link> links = boundary_links(mesh);
  const auto& edges = mesh.boundary_edges();
  std::vector<Chain> chains;
  for (Index e = 0; e < Index(edges.size()); ++e)
    for (const bool forward : {true, false}) {
      if (!lies_on_axis(mesh, edges[e])) continue;
      const auto next = [&](Index edge) { return forward ? links[edge].next : links[edge].previous; };
      Chain chain{e, forward, {}};
      for (Index at = next(e); !lies_on_axis(mesh, edges[at]); at = next(at)) chain.edges.push_back(at);
      if (!chain.edges.empty()) chains.push_back(std::move(chain));
    }
  return chains;
}

/// How many edges of a chain lie before the last of its vertices that has come to the axis, and the volume that they
/// enclose, m3; none where that is more than `max_volume` or the axis would turn back.
std::pair<std::size_t, double> closed_part(const Mesh& mesh, const Chain& chain, double max_volume) {
  const Point& pole = mesh.nodes[chain.node(mesh, chain.edges.front(), 0)];
  const Point& inner = mesh.nodes[chain.node(mesh, chain.axis_edge, 0)];  // of both nodes the one within the axis
  std::pair<std::size_t, double> closed{0, 0};
  double volume = 0;
  for (std::size_t k = 0; k + 1 < chain.edges.size(); ++k) {
    volume += volume_to_axis(mesh, mesh.boundary_edges()[chain.edges[k]]);
    const Point& x = mesh.nodes[chain.node(mesh, chain.edges[k], 1)];
    const bool onwards = (x[1] - pole[1]) * (pole[1] - inner[1]) > 0;
    if (x[0] <= 0 && onwards && std::abs(volume) <= max_volume) closed = {k + 1, std::abs(volume)};
  }
  return closed;
}

}  // namespace

bool has_reached_axis(const Mesh& mesh) {
  const auto& edges = mesh.boundary_edges();
  std::vector<bool> of_axis(mesh.nodes.size(), false);
  for (const auto& edge : edges)
    if (mesh.kind_of(edge) == core::BoundaryKind::symmetry)
      for (const Index n : edge.nodes) of_axis[n] = true;
  return std::any_of(edges.begin(), edges.end(), [&](const core::BoundaryEdge& edge) {
    return !of_axis[edge.nodes[1]] && mesh.nodes[edge.nodes[1]][0] <= 0;
  });
}

ClosedOnAxis close_on_axis(Mesh mesh, double max_volume) {
  ClosedOnAxis result;
  std::vector<bool> leaves(mesh.boundary_edges().size(), false);
  for (const Chain& chain : chains_from_axis(mesh)) {
    const auto [count, volume] = closed_part(mesh, chain, max_volume);
    if (count == 0 || leaves[chain.edges[count - 1]]) continue;
    const Index pole = chain.node(mesh, chain.edges.front(), 0), end = chain.node(mesh, chain.edges[count - 1], 1);
    const Index axis = mesh.boundary_edges()[chain.axis_edge].boundary_id;
    core::BoundaryEdge& extension = mesh.edit().boundary_edges[chain.edges.front()];
    mesh.nodes[end][0] = 0;
    mesh.nodes[extension.nodes[2]] = 0.5 * (mesh.nodes[pole] + mesh.nodes[end]);
    extension.nodes[chain.forward ? 1 : 0] = end;
    extension.boundary_id = axis;
    for (std::size_t k = 1; k < count; ++k) leaves[chain.edges[k]] = true;
    ++result.voids;
    result.volume += volume;
  }
  std::vector<core::BoundaryEdge> kept;
  for (std::size_t e = 0; e < leaves.size(); ++e)
    if (!leaves[e]) kept.push_back(mesh.boundary_edges()[e]);
  mesh.edit().boundary_edges = std::move(kept);
  result.mesh = std::move(mesh);
  return result;
}

}  // namespace parison::remesh
