// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/edge_correction.hpp"

#include <algorithm>
#include <array>
#include <type_traits>

#include "core/mesh/element.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/state/glass_fields.hpp"
#include "forming/state/initial_state.hpp"
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

EdgeNodes local_nodes(const core::BoundaryEdge& edge, const core::Mesh& mesh, const PlacedTools::Tool& tool) {
  EdgeNodes local;
  for (int i = 0; i < 3; ++i) local[i] = mesh.nodes[edge.nodes[i]] - tool.shift;
  return local;
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
    const bool has = std::any_of(nodes.begin(), nodes.end(),
                                 [&](Index node) { return std::find(own.begin(), own.end(), node) != own.end(); });
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
  Point shift = shift_of_middle(tool, local_nodes(edge, mesh, tool), placed.at_tool);
  if (shift.norm() < placed.coincident) return false;
  for (int i = 0; i <= halvings; ++i, shift *= 0.5)
    if (moves_soundly(edge, shift, mesh)) return true;
  return false;
}

/// Where on an edge, whose middle node lies at the share `middle` of the way from its first to its last one, the share
/// `wanted` of it is reached.
double place_at(double wanted, double middle) {
  double low = 0, high = 1;
  for (int i = 0; i < 50; ++i) {
    const double s = 0.5 * (low + high);
    const auto n = core::edge_shape(s);
    (n[1] + n[2] * middle < wanted ? low : high) = s;
  }
  return low;
}

/// A point of an edge in other node positions than those of its mesh.
Point place_on(const core::BoundaryEdge& edge, double s, const std::vector<Point>& nodes) {
  return point_on({nodes[edge.nodes[0]], nodes[edge.nodes[1]], nodes[edge.nodes[2]]}, s);
}

/// Puts the middle node of an edge, with all fields of the glass there, at another place of the same edge.
void slide_middle(const core::BoundaryEdge& edge, double s, GlassState& glass) {
  const auto n = core::edge_shape(s);
  const auto between = [&](auto&& at) {
    return (n[0] * at(edge.nodes[0]) + n[1] * at(edge.nodes[1]) + n[2] * at(edge.nodes[2])).eval();
  };
  for (std::vector<Point>* nodes : {&glass.mesh.nodes, &glass.mass_nodes})
    (*nodes)[edge.nodes[2]] = place_on(edge, s, *nodes);
  const auto slide = [&](auto& field) {
    if constexpr (std::is_same_v<std::decay_t<decltype(field)>, Eigen::VectorXd>)
      if (const Index width = static_cast<Index>(field.size()) / glass.mesh.node_count(); width > 0)
        field.segment(width * edge.nodes[2], width) =
            between([&](Index node) { return field.segment(width * node, width); });
  };
  for_each_glass_field([&](const auto& field) { slide(glass.*field.values); });
  slide(glass.mass_temperature);
}

/// Slides the middle node of an edge on a rounding of a tool to where it is off the middle by no more than lets the
/// edge cut it by `placed.resting`, m: off by a share d, an edge of length L on an arc of radius R cuts it by 0.4 d
/// L^2/R. Not where its cell would be inverted, nor in a hollow, where the middle may be in its corner, nor where the
/// edge would cut the tool no less, as over a corner beside one of its ends.
bool centre_middle(const PlacedTools& placed, const core::BoundaryEdge& edge, GlassState& glass) {
  constexpr double depth_of_share = 3.2;  // depth over the share that the middle is off and the height of the arc
  core::Mesh& mesh = glass.mesh;
  const Point along = mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]];
  const Point arm = mesh.nodes[edge.nodes[2]] - mesh.nodes[edge.nodes[0]];
  const double middle = arm.dot(along) / along.squaredNorm();
  const double height = (along[0] * arm[1] - along[1] * arm[0]) / along.norm();  // into the glass, above the chord
  if (height <= placed.resting) return false;
  const double most = placed.resting / (depth_of_share * height);
  const double wanted = std::clamp(middle, 0.5 - most, 0.5 + most), s = place_at(wanted, middle);
  if (wanted == middle) return false;
  const PlacedTools::Tool& tool = placed.of(glass.contact_tool[edge.nodes[0]]);
  const auto needed = [&] { return shift_of_middle(tool, local_nodes(edge, mesh, tool), placed.at_tool).norm(); };
  const Point before = mesh.nodes[edge.nodes[2]];
  const double needed_before = needed();
  mesh.nodes[edge.nodes[2]] = place_on(edge, s, mesh.nodes);
  const bool helps = remesh::cell_quality(mesh, edge.cell) > 0 && needed() < needed_before;
  mesh.nodes[edge.nodes[2]] = before;
  if (helps) slide_middle(edge, s, glass);
  return helps;
}

/// Where an edge that touches a tool with all its nodes lies in it between them.
bool is_cut(const PlacedTools& placed, const core::BoundaryEdge& edge, const GlassState& glass) {
  const Index tool = glass.contact_tool[edge.nodes[0]];
  const auto touches = [&](Index node) { return glass.contact_tool[node] == tool; };
  if (tool < 0 || !std::all_of(edge.nodes.begin(), edge.nodes.end(), touches)) return false;
  return shift_of_middle(placed.of(tool), local_nodes(edge, glass.mesh, placed.of(tool)), placed.at_tool).norm() >=
         placed.coincident;
}

}  // namespace

bool centre_middles(const Scene& scene, State& state) {
  constexpr int corrections = 2;  // the heat capacity hardly changes over the millikelvins in question
  GlassState& glass = state.glass;
  const PlacedTools placed = placed_tools(scene, state);
  std::vector<core::BoundaryEdge> cut;
  for (const auto& edge : glass.mesh.boundary_edges())
    if (is_cut(placed, edge, glass)) cut.push_back(edge);
  if (cut.empty()) return false;
  const double heat = scene.has_heat() ? glass_heat(scene, state) : 0;
  const double mass = relative_mass(scene, glass);
  std::vector<Index> slid;
  for (const auto& edge : cut)
    if (centre_middle(placed, edge, glass)) slid.push_back(edge.nodes[2]);
  glass.density *= mass / relative_mass(scene, glass);
  const auto warm = [&](double by) {
    for (const Index node : slid) glass.temperature[node] += by;
  };
  for (int i = 0; scene.has_heat() && !slid.empty() && i < corrections; ++i) {
    const double missing = heat - glass_heat(scene, state);
    warm(1);
    const double capacity = glass_heat(scene, state) - heat + missing;  // of the nodes that slid, J/K
    warm(missing / capacity - 1);
  }
  return !slid.empty();
}

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
  const bool slid = centre_middles(scene, state);
  if ((move_edges_out(scene, state, state.glass.contact_tool, mesh) || slid) &&
      !shift_free_surface(scene, state, volume, mesh))
    restore_volume(scene, state, volume, mesh);
}

}  // namespace parison::forming
