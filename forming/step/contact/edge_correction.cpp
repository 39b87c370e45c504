// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/edge_correction.hpp"

#include <algorithm>
#include <array>

#include "core/mesh/element.hpp"
#include "forming/step/balance/volume_conservation.hpp"
#include "forming/step/contact/penetration.hpp"
#include "forming/step/contact/placed_tools.hpp"
#include "remesh/mesher/quality.hpp"

namespace parison::forming {

namespace {

/// First, last and middle node, m, in the frame of a tool.
using EdgeNodes = std::array<Point, 3>;

Point point_on(const EdgeNodes& edge, double s) {
  const auto n = core::edge_shape(s);
  return n[0] * edge[0] + n[1] * edge[1] + n[2] * edge[2];
}

/// The shift of an edge's middle node, m, that moves the place of the edge which needs most out of the tool.
Point shift_of_middle(const PlacedTools::Tool& tool, const EdgeNodes& edge, double allowed) {
  std::size_t closest = 0;
  const double first = tool.gap.deepest(edge[0], 0, closest), last = tool.gap.deepest(edge[1], 0, closest);
  double largest = 0, at = 0;
  for (const double s : places_on(edge, *tool.profile)) {
    if (s <= 0 || s >= 1) continue;
    const double kept = std::max(allowed, (1 - s) * first + s * last);
    const double shift = (tool.gap.deepest(point_on(edge, s), kept, closest) - kept) / core::edge_shape(s)[2];
    if (shift > largest) largest = shift, at = s;
  }
  if (largest == 0) return Point::Zero();
  const auto found = tool.constraints(point_on(edge, at), (edge[1] - edge[0]).norm());
  return found.empty() ? Point::Zero() : Point(largest * found.front().normal);
}

/// The nodes of a cell that lie inside the glass, not on its surface.
std::vector<Index> inner_nodes(const core::Mesh& mesh, Index cell) {
  const auto& nodes = mesh.cells()[cell];
  std::vector<Index> inner(nodes.begin(), nodes.end());
  for (const auto& edge : mesh.boundary_edges())
    for (const Index node : edge.nodes) inner.erase(std::remove(inner.begin(), inner.end(), node), inner.end());
  return inner;
}

/// Whether no cell that has one of these nodes is inverted.
bool all_sound(const core::Mesh& mesh, const std::vector<Index>& nodes) {
  for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
    const auto& own = mesh.cells()[cell];
    const bool has = std::any_of(nodes.begin(), nodes.end(), [&](Index node) {
      return std::find(own.begin(), own.end(), node) != own.end();
    });
    if (has && remesh::cell_quality(mesh, cell) <= 0) return false;
  }
  return true;
}

/// Moves the middle node of an edge, alone or where its cell is too flat for that with the cell's inner nodes; false,
/// and nothing moved, where a cell would be inverted.
bool moves_soundly(const core::BoundaryEdge& edge, const Point& shift, core::Mesh& mesh) {
  const Index middle = edge.nodes[2];
  mesh.nodes[middle] += shift;
  if (remesh::cell_quality(mesh, edge.cell) > 0) return true;
  std::vector<Index> moved = inner_nodes(mesh, edge.cell);
  for (const Index node : moved) mesh.nodes[node] += shift;
  moved.push_back(middle);
  if (moved.size() > 1 && all_sound(mesh, moved)) return true;
  for (const Index node : moved) mesh.nodes[node] -= shift;
  return false;
}

/// Moves an edge out of a tool as far as its cell stays sound; false where it is not in the tool.
bool move_out(const PlacedTools& placed, const PlacedTools::Tool& tool, const core::BoundaryEdge& edge,
              core::Mesh& mesh) {
  constexpr int halvings = 3;
  EdgeNodes local;
  for (int i = 0; i < 3; ++i) local[i] = mesh.nodes[edge.nodes[i]] - tool.shift;
  Point shift = shift_of_middle(tool, local, placed.at_tool);
  if (shift.norm() < placed.coincident) return false;
  for (int i = 0; i <= halvings; ++i, shift *= 0.5)
    if (moves_soundly(edge, shift, mesh)) return true;
  return false;
}

}  // namespace

bool move_edges_out(const Scene& scene, const State& state, const std::vector<Index>& touched, core::Mesh& mesh) {
  constexpr int rounds = 3;  // a second place of an edge may need more than the first
  const PlacedTools placed = placed_tools(scene, state);
  bool any = false, moved = true;
  for (int round = 0; round < rounds && moved; ++round) {
    moved = false;
    for (const auto& tool : placed.tools)
      for (const auto& edge : mesh.boundary_edges()) {
        const auto touches = [&](Index node) { return touched[node] == tool.index; };
        if (mesh.kind_of(edge) == BoundaryKind::contact && std::any_of(edge.nodes.begin(), edge.nodes.end(), touches) &&
            move_out(placed, tool, edge, mesh))
          any = moved = true;
      }
  }
  return any;
}

void correct_edges(const Scene& scene, State& state) {
  core::Mesh& mesh = state.glass.mesh;
  const double volume = core::volume(mesh, scene.geometry);
  if (move_edges_out(scene, state, state.glass.contact_tool, mesh)) restore_volume(scene, state, volume, mesh);
}

}  // namespace parison::forming
