// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/thickness_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/io/files.hpp"
#include "core/mesh/element.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/state/sample.hpp"
#include "remesh/surface/wall_thickness.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

namespace {

/// Past the last edge of the loop that begins at `begin`.
Index loop_end(const core::Mesh& mesh, Index begin) {
  Index end = begin + 1;
  while (end < static_cast<Index>(mesh.boundary_edges().size()) &&
         mesh.boundary_edges()[end].nodes[0] == mesh.boundary_edges()[end - 1].nodes[1])
    ++end;
  return end;
}

double arc_length(const core::Mesh& mesh, const core::BoundaryEdge& edge) {
  double length = 0;
  for (const core::EdgeRulePoint& at : core::edge_rule(3))
    length += core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, at).area;
  return length;
}

}  // namespace

std::vector<bool> loaded_boundaries(const Scene& scene, const core::Mesh& glass) {
  std::vector<bool> loaded(glass.boundaries().size(), false);
  const auto last = std::find_if(scene.stages.rbegin(), scene.stages.rend(),
                                 [](const Stage& stage) { return !stage.pressure.empty(); });
  if (last == scene.stages.rend()) return loaded;
  for (const auto& entry : last->pressure)
    if (const Index index = core::find_boundary(glass, entry.first); index >= 0) loaded[index] = true;
  return loaded;
}

std::vector<ChainEdge> walk_surface(const core::Mesh& mesh, const std::vector<bool>& wanted_boundaries) {
  const auto wanted = [&](Index edge) { return wanted_boundaries.at(mesh.boundary_edges()[edge].boundary_id); };
  std::vector<ChainEdge> chain;
  double arc = 0;
  for (Index begin = 0; begin < static_cast<Index>(mesh.boundary_edges().size());) {
    const Index end = loop_end(mesh, begin), count = end - begin;
    Index first = begin;
    for (Index edge = begin; edge < end; ++edge)
      if (wanted(edge) && !wanted(edge > begin ? edge - 1 : end - 1)) {
        first = edge;
        break;
      }
    for (Index k = 0; k < count; ++k) {
      const Index edge = begin + (first - begin + k) % count;
      if (!wanted(edge)) continue;
      chain.push_back({edge, arc, arc_length(mesh, mesh.boundary_edges()[edge])});
      arc += chain.back().length;
    }
    begin = end;
  }
  return chain;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<bool> outer_boundaries(const Scene& scene, const core::Mesh& glass) {
  std::vector<bool> outer = core::boundaries_of_kind(glass, BoundaryKind::symmetry);
  const std::vector<bool> loaded = loaded_boundaries(scene, glass);
  for (std::size_t boundary_id = 0; boundary_id < outer.size(); ++boundary_id)
    outer[boundary_id] = !outer[boundary_id] && !loaded[boundary_id];
  return outer;
}

double distance_to_chord(const Point& x, const Point& a, const Point& b) {
  const double along = (x - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-300);
  return (x - a - std::clamp(along, 0.0, 1.0) * (b - a)).norm();
}

/// Boundary edge nearest to x, symmetry boundaries aside.
const core::BoundaryEdge& nearest_edge(const core::Mesh& mesh, const std::vector<bool>& symmetry, const Point& x) {
  double nearest = infinity;
  const core::BoundaryEdge* found = &mesh.boundary_edges().front();
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (symmetry[edge.boundary_id]) continue;
    const auto& [first, last, mid] = edge.nodes;
    const double distance = std::min(distance_to_chord(x, mesh.nodes[first], mesh.nodes[mid]),
                                     distance_to_chord(x, mesh.nodes[mid], mesh.nodes[last]));
    if (distance < nearest) nearest = distance, found = &edge;
  }
  return *found;
}

/// Largest cosine between the normals of a wall's two sides: an end face looks along the wall, not through it.
constexpr double facing = -0.8;

/// Outward unit normal at each surface node, the mean of those of the edges that meet there.
std::vector<Point> node_normals(const core::Mesh& mesh, const std::vector<bool>& symmetry) {
  std::vector<Point> normals(mesh.nodes.size(), Point::Zero());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (symmetry[edge.boundary_id]) continue;
    constexpr std::array<double, 3> places{0, 1, 0.5};
    for (int k = 0; k < 3; ++k)
      normals[edge.nodes[k]] += core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, {places[k], 1}).normal;
  }
  for (Point& normal : normals) normal.normalize();
  return normals;
}

/// Rows with position and area, in the order of walking the outer surface; `nodes` gets the node of each.
std::vector<ThicknessRow> make_rows(const Scene& scene, const core::Mesh& mesh, std::vector<Index>& nodes) {
  std::vector<ThicknessRow> rows;
  std::vector<Index> row_of(mesh.nodes.size(), -1);
  const auto row = [&](Index node, double arc) -> ThicknessRow& {
    if (row_of[node] < 0) {
      row_of[node] = static_cast<Index>(rows.size());
      nodes.push_back(node);
      rows.push_back({arc, mesh.nodes[node], 0, 0, 0, 0, true});
    }
    return rows[row_of[node]];
  };
  for (const ChainEdge& edge : walk_surface(mesh, outer_boundaries(scene, mesh))) {
    const auto& [first, last, mid] = mesh.boundary_edges()[edge.edge].nodes;
    row(first, edge.start);
    row(mid, edge.start + 0.5 * edge.length);
    row(last, edge.start + edge.length);
    for (const core::EdgeRulePoint& at : core::edge_rule(3)) {
      const auto point = core::map_edge_point(mesh, mesh.boundary_edges()[edge.edge].nodes, scene.geometry, at);
      for (int k = 0; k < 3; ++k) row(mesh.boundary_edges()[edge.edge].nodes[k], 0).area += point.shape[k] * point.area;
    }
  }
  return rows;
}

}  // namespace

std::vector<Index> outer_edges(const Scene& scene, const core::Mesh& glass) {
  const std::vector<bool> outer = outer_boundaries(scene, glass);
  std::vector<Index> edges;
  for (std::size_t edge = 0; edge < glass.boundary_edges().size(); ++edge)
    if (outer[glass.boundary_edges()[edge].boundary_id]) edges.push_back(static_cast<Index>(edge));
  return edges;
}

std::vector<ThicknessRow> thickness_profile(const Scene& scene, const State& state) {
  const GlassState& glass = state.glass;
  const core::Mesh& mesh = glass.mesh;
  const std::vector<bool> symmetry = core::boundaries_of_kind(mesh, BoundaryKind::symmetry),
                          loaded = loaded_boundaries(scene, mesh);
  const bool any_loaded = std::count(loaded.begin(), loaded.end(), true) > 0;
  const Eigen::VectorXd thickness = remesh::wall_thickness(mesh);
  const std::vector<Point> normals = node_normals(mesh, symmetry);
  std::vector<Index> nodes;
  std::vector<ThicknessRow> rows = make_rows(scene, mesh, nodes);

  std::vector<Point> opposite;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].thickness = thickness[nodes[i]];
    opposite.push_back(rows[i].position - rows[i].thickness * normals[nodes[i]]);
    const core::BoundaryEdge& far_side = nearest_edge(mesh, symmetry, opposite.back());
    const Point far_normal = core::map_edge_point(mesh, far_side.nodes, core::Geometry::planar, {0.5, 1}).normal;
    rows[i].is_wall = !any_loaded || (loaded[far_side.boundary_id] && far_normal.dot(normals[nodes[i]]) < facing);
    rows[i].inner_temperature = rows[i].outer_temperature = std::numeric_limits<double>::quiet_NaN();
  }
  if (!scene.has_heat()) return rows;
  const Eigen::MatrixXd inner = sample(mesh, glass.temperature, 1, opposite);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].inner_temperature = inner(i, 0);
    rows[i].outer_temperature = glass.temperature[nodes[i]];
  }
  return rows;
}

ThicknessRange thickness_range(const std::vector<ThicknessRow>& rows) {
  double lowest = infinity, highest = -infinity, sum = 0, area = 0;
  for (const ThicknessRow& row : rows) {
    if (!row.is_wall) continue;
    lowest = std::min(lowest, row.thickness);
    highest = std::max(highest, row.thickness);
    sum += row.area * row.thickness;
    area += row.area;
  }
  return {lowest, sum / area, highest};
}

void write_thickness(const std::string& path, const std::vector<ThicknessRow>& rows) {
  std::string text = "arc_mm,r_outer_mm,z_outer_mm,thickness_mm,T_inner_C,T_outer_C\n";
  for (const ThicknessRow& row : rows)
    text += fmt::format("{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g}\n", 1e3 * row.arc, 1e3 * row.position[0],
                        1e3 * row.position[1], 1e3 * row.thickness, row.inner_temperature - thermal::content_reference,
                        row.outer_temperature - thermal::content_reference);
  core::replace_file(path, text);
}

}  // namespace parison::forming
