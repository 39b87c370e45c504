// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/thickness_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/io/files.hpp"
#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"
#include "forming/report/wall/wall_marks.hpp"
#include "forming/state/sample.hpp"
#include "remesh/wall/surface_chain.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {

namespace {

double arc_length(const core::Mesh& mesh, const core::BoundaryEdge& edge) {
  double length = 0;
  for (const core::EdgeRulePoint& at : core::edge_rule(3))
    length += core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, at).area;
  return length;
}

}  // namespace

std::vector<ChainEdge> walk_edges(const core::Mesh& mesh, const std::vector<bool>& wanted) {
  std::vector<ChainEdge> chain;
  double arc = 0;
  for (Index begin = 0; begin < static_cast<Index>(mesh.boundary_edges().size());) {
    const Index end = remesh::loop_end(mesh, begin), count = end - begin;
    Index first = begin;
    for (Index edge = begin; edge < end; ++edge)
      if (wanted[edge] && !wanted[edge > begin ? edge - 1 : end - 1]) {
        first = edge;
        break;
      }
    for (Index k = 0; k < count; ++k) {
      const Index edge = begin + (first - begin + k) % count;
      if (!wanted[edge]) continue;
      chain.push_back({edge, arc, arc_length(mesh, mesh.boundary_edges()[edge])});
      arc += chain.back().length;
    }
    begin = end;
  }
  return chain;
}

std::vector<ChainEdge> walk_surface(const core::Mesh& mesh, const std::vector<bool>& wanted_boundaries) {
  std::vector<bool> wanted;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) wanted.push_back(wanted_boundaries.at(edge.boundary_id));
  return walk_edges(mesh, wanted);
}

namespace {

/// What glass needs to be a wall: surface with another side opposite over all of it.
constexpr double least_share = 0.25;

/// Rows with place and area, in the order of walking the wanted edges; `nodes` says whose they are.
std::vector<ThicknessRow> make_rows(const core::Mesh& mesh, core::Geometry geometry, const std::vector<bool>& wanted,
                                    std::vector<Index>& nodes) {
  std::vector<ThicknessRow> rows;
  std::vector<Index> row_of(mesh.nodes.size(), -1);
  nodes.clear();
  const auto row = [&](Index node, double arc) -> ThicknessRow& {
    if (row_of[node] < 0) {
      row_of[node] = static_cast<Index>(rows.size());
      nodes.push_back(node);
      rows.push_back(
          {arc, mesh.nodes[node], core::none, core::none, core::none, 0, WallMark::none, Point::Constant(core::none)});
    }
    return rows[row_of[node]];
  };
  for (const ChainEdge& edge : walk_edges(mesh, wanted)) {
    const auto& [first, last, mid] = mesh.boundary_edges()[edge.edge].nodes;
    row(first, edge.start);
    row(mid, edge.start + 0.5 * edge.length);
    row(last, edge.start + edge.length);
    for (const core::EdgeRulePoint& at : core::edge_rule(3)) {
      const auto point = core::map_edge_point(mesh, mesh.boundary_edges()[edge.edge].nodes, geometry, at);
      for (int k = 0; k < 3; ++k) row(mesh.boundary_edges()[edge.edge].nodes[k], 0).area += point.shape[k] * point.area;
    }
  }
  return rows;
}

/// The wall's direction at a row, m, towards higher rows: that of both its sides.
Point direction_at(const std::vector<ThicknessRow>& rows, std::size_t row) {
  const ThicknessRow &before = rows[row - 1], &after = rows[row + 1];
  return (after.position - before.position).normalized() + (after.inner_position - before.inner_position).normalized();
}

/// The arc of the middle of the rim behind the last wall row (`step` 1), or before the first (-1), m; not a number
/// where there is none.
double middle_of_rim(const core::Mesh& mesh, const std::vector<Index>& nodes, const std::vector<ThicknessRow>& rows,
                     int step) {
  const auto count = static_cast<Index>(rows.size());
  const Index end = step > 0 ? count - 1 : 0;
  Index last = end;
  while (last >= 0 && last < count && !rows[last].is_wall()) last -= step;
  if (last == end || last < 0 || last >= count) return core::none;
  const auto is_wall = [&](Index row) { return row >= 0 && row < count && rows[row].is_wall(); };
  Index row = last - step;  // as far from the rim as the wall is thick, where the wall is so long
  while (is_wall(row - step) && std::abs(rows[last].arc - rows[row].arc) < rows[row].thickness) row -= step;
  if (!is_wall(row) || !is_wall(row - step)) return core::none;
  const Point direction = step * direction_at(rows, static_cast<std::size_t>(row));
  const auto& edges = mesh.boundary_edges();
  for (Index edge = 0; edge < static_cast<Index>(edges.size()); ++edge) {
    const auto [first, second, middle] = edges[edge].nodes;
    const bool begins = nodes[row] == (step > 0 ? first : second);
    if (!begins && nodes[row] != middle) continue;
    return rim_middle(
        mesh, {edge, rows[begins ? row : row - step].arc, step > 0, direction.normalized(), 0.5 * rows[row].thickness});
  }
  return core::none;
}

double area_of(const core::Mesh& mesh, core::Geometry geometry, const std::vector<bool>& edges) {
  double area = 0;
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
    for (const core::EdgeRulePoint& at : core::edge_rule(3))
      if (edges[edge]) area += core::map_edge_point(mesh, mesh.boundary_edges()[edge].nodes, geometry, at).area;
  return area;
}

/// Why marked rows make no wall; empty where they do.
std::string objection(const core::Mesh& mesh, core::Geometry geometry, const remesh::WallSides& sides,
                      const std::vector<Index>& nodes, const std::vector<ThicknessRow>& rows) {
  double area = 0;
  for (const ThicknessRow& row : rows) area += row.is_wall() ? row.area : 0;
  const double whole =
      area_of(mesh, geometry,
              edges_of(sides, {remesh::SurfacePart::outer, remesh::SurfacePart::inner, remesh::SurfacePart::rim}));
  const double share = (sides.is_mirrored ? 1 : 2) * area / whole;
  const double length = wall_length(mesh, nodes, rows);
  if (share < least_share)
    return fmt::format("the glass is no wall: {:.0f} % of its surface lies opposite another side, a wall has {:.0f} %",
                       100 * share, 100 * least_share);
  const double mean = thickness_range(rows).mean;
  if (length < least_wall_length * mean)
    return fmt::format("the glass is no wall: {:.3g} mm thick and {:.3g} mm long", 1e3 * mean, 1e3 * length);
  return {};
}

void add_temperatures(const GlassState& glass, const std::vector<Index>& nodes, std::vector<ThicknessRow>& rows) {
  std::vector<Point> opposite;
  opposite.reserve(rows.size());
  for (const ThicknessRow& row : rows) opposite.push_back(row.is_wall() ? row.inner_position : row.position);
  const Eigen::MatrixXd inner = sample(glass.mesh, glass.temperature, 1, opposite);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].is_wall()) rows[i].inner_temperature = inner(static_cast<Index>(i), 0);
    rows[i].outer_temperature = glass.temperature[nodes[i]];
  }
}

std::vector<bool> whole_surface(const core::Mesh& mesh) {
  const std::vector<bool> symmetry = core::boundaries_of_kind(mesh, BoundaryKind::symmetry);
  std::vector<bool> edges;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) edges.push_back(!symmetry[edge.boundary_id]);
  return edges;
}

/// Rays that neither start nor end on a fixed boundary.
std::vector<remesh::Ray> rays_between_free_sides(const core::Mesh& mesh, std::vector<remesh::Ray> rays) {
  const std::vector<bool> fixed = core::boundaries_of_kind(mesh, BoundaryKind::fixed);
  std::vector<bool> is_free(mesh.nodes.size(), false);
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    for (const Index node : edge.nodes) is_free[node] = is_free[node] || !fixed[edge.boundary_id];
  for (std::size_t node = 0; node < rays.size(); ++node)
    if (!is_free[node] || (rays[node].ends() && fixed[mesh.boundary_edges()[rays[node].edge].boundary_id]))
      rays[node] = {};
  return rays;
}

ThicknessProfile profile_by_rays(const core::Mesh& mesh, core::Geometry geometry,
                                 const std::vector<remesh::Ray>& rays) {
  ThicknessProfile profile;
  profile.rays = rays;
  const remesh::WallSides& sides = profile.sides = remesh::wall_sides(mesh, geometry, rays);
  profile.no_wall = sides.no_wall;
  std::vector<bool> wanted = edges_of(sides, {remesh::SurfacePart::outer, remesh::SurfacePart::rim});
  std::vector<Index>& nodes = profile.nodes;
  if (profile.no_wall.empty()) {
    profile.rows = make_rows(mesh, geometry, wanted, nodes);
    mark_wall(mesh, geometry, sides, rays, nodes, profile.rows);
    profile.no_wall = objection(mesh, geometry, sides, nodes, profile.rows);
  }
  if (!profile.no_wall.empty()) {
    profile.rows = make_rows(mesh, geometry, wanted = whole_surface(mesh), nodes);
    profile.sides.part.assign(mesh.boundary_edges().size(), remesh::SurfacePart::none);
  }
  for (std::size_t edge = 0; edge < wanted.size(); ++edge)
    if (wanted[edge]) profile.outer_edges.push_back(static_cast<Index>(edge));
  const auto end_of = [&](int step, double arc) {
    const double middle = profile.no_wall.empty() ? middle_of_rim(mesh, nodes, profile.rows, step) : core::none;
    return std::isnan(middle) ? arc : middle;
  };
  profile.first_arc = profile.rows.empty() ? 0 : end_of(-1, profile.rows.front().arc);
  profile.last_arc = profile.rows.empty() ? 0 : end_of(1, profile.rows.back().arc);
  return profile;
}

}  // namespace

ThicknessProfile thickness_profile(const core::Mesh& mesh, core::Geometry geometry) {
  const std::vector<remesh::Ray> rays = remesh::surface_rays(mesh, geometry);
  ThicknessProfile profile = profile_by_rays(mesh, geometry, rays_between_free_sides(mesh, rays));
  return profile.no_wall.empty() ? profile : profile_by_rays(mesh, geometry, rays);
}

ThicknessProfile thickness_profile(const Scene& scene, const State& state) {
  ThicknessProfile profile = thickness_profile(state.glass.mesh, scene.geometry);
  if (scene.has_heat()) add_temperatures(state.glass, profile.nodes, profile.rows);
  return profile;
}

ThicknessRange thickness_range(const std::vector<ThicknessRow>& rows) {
  ThicknessRange range{core::infinity, core::none, -core::infinity, Point::Constant(core::none),
                       Point::Constant(core::none)};
  double sum = 0, area = 0;
  for (const ThicknessRow& row : rows) {
    if (!row.is_wall()) continue;
    if (row.thickness < range.lowest)
      range.lowest = row.thickness, range.lowest_at = row.position, range.lowest_arc = row.arc;
    if (row.thickness > range.highest) range.highest = row.thickness, range.highest_at = row.position;
    sum += row.area * row.thickness;
    area += row.area;
  }
  if (area <= 0) return {core::none, core::none, core::none, range.lowest_at, range.highest_at};
  range.mean = sum / area;
  return range;
}

ThicknessRange thickness_beside_finish(const Scene& scene, const State& state, const ThicknessProfile& profile) {
  double low = core::infinity, high = -core::infinity;
  for (std::size_t i = 0; i < profile.rows.size(); ++i) {
    const Index tool = state.glass.contact_tool[profile.nodes[i]];
    if (tool < 0 || scene.tools[tool].friction.law != flow::Friction::Law::grip) continue;
    low = std::min(low, profile.rows[i].position[1]);
    high = std::max(high, profile.rows[i].position[1]);
  }
  std::vector<ThicknessRow> rows;
  for (const ThicknessRow& row : profile.rows)
    if (low <= high && (row.position[1] < low || row.position[1] > high)) rows.push_back(row);
  return thickness_range(rows);
}

void write_thickness(const std::string& path, const std::vector<ThicknessRow>& rows) {
  std::string text = "arc_mm,r_outer_mm,z_outer_mm,thickness_mm,T_inner_degC,T_outer_degC,mark,r_inner_mm,z_inner_mm\n";
  for (const ThicknessRow& row : rows)
    text += fmt::format(
        "{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{},{:.8g},{:.8g}\n", 1e3 * row.arc, 1e3 * row.position[0],
        1e3 * row.position[1], 1e3 * row.thickness, row.inner_temperature - thermal::content_reference,
        row.outer_temperature - thermal::content_reference, wall_mark_names[static_cast<std::size_t>(row.mark)],
        1e3 * row.inner_position[0], 1e3 * row.inner_position[1]);
  core::replace_file(path, text, core::Reach::system);
}

}  // namespace parison::forming
