// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/swept_tool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/process/run_error.hpp"

namespace parison::forming {

namespace {

/// Distance from a place of a body to its boundaries of some kinds, m; infinite where it has none.
template <typename Wanted>
double distance_to(const Body& body, const Point& at, const Wanted& wanted) {
  double nearest = HUGE_VAL;
  for (const core::Segment& segment : body.profile.segments)
    if (wanted(body.boundaries[segment.boundary_id].kind)) nearest = core::distance(segment, at, nearest);
  return nearest;
}

/// Distance to the cooled and open sides of a tool, m.
double distance_outside(const Body& tool, const Point& at) {
  return distance_to(tool, at, [](BoundaryKind kind) {
    return kind == BoundaryKind::cooled || kind == BoundaryKind::air || kind == BoundaryKind::temperature;
  });
}

/// How near a place of a tool is to the glass: 1 there, 0 at its cooled and open sides.
double nearness_to_glass(const Body& tool, const Point& at) {
  const double to_glass = distance_to(tool, at, [](BoundaryKind kind) { return kind == BoundaryKind::contact; });
  const double to_outside = distance_outside(tool, at);
  return std::isfinite(to_outside) && to_glass + to_outside > 0 ? to_outside / (to_glass + to_outside) : 1;
}

/// How much the cooled sides of a tool have of the shape of its sections: none, where corners then leave half of the
/// wall that is drawn.
double share_outside(const Tool& tool) {
  constexpr double kept = 0.5;             // of the wall
  constexpr int along = 16, quarter = 32;  // places of a segment, and of a quarter turn
  const auto contact = contact_boundaries(tool);
  double share = 0;
  for (const core::Segment& segment : tool.profile.segments)
    for (int i = 0; contact[segment.boundary_id] && i <= along; ++i) {
      const Point at = core::point_at(segment, double(i) / along);
      const double wall = distance_outside(tool, at);
      if (!std::isfinite(wall)) return 1;
      for (int turn = 0; turn <= quarter; ++turn) {
        const double beyond = core::reach(tool.section, at, M_PI_2 * turn / quarter) - 1;
        const double lack = at[0] * beyond - (1 - kept) * wall;
        if (lack > 0) share = std::max(share, lack / ((at[0] + wall) * beyond));
      }
    }
  return share;
}

core::SectionMap section_map(const Tool& tool) {
  if (tool.section.is_round()) return core::round_section;
  const double outside = share_outside(tool);
  return [&tool, outside](double r, double z, double angle) {
    const double share = outside + (1 - outside) * nearness_to_glass(tool, {r, z});
    const double radius = r * (1 + share * (core::reach(tool.section, {r, z}, angle) - 1));
    return core::Vector3(radius * std::cos(angle), radius * std::sin(angle), z);
  };
}

/// Sets the middles of edges within the section halfway between their ends: shapes that change within a cell do not
/// fold it then.
void straighten_inside(const core::Mesh& section, core::PrismMesh& mesh) {
  std::vector<bool> is_middle_outside(section.nodes.size(), false);
  for (const core::BoundaryEdge& edge : section.boundary_edges()) is_middle_outside[edge.nodes[2]] = true;
  constexpr int per_level = 6, corners = 3;
  for (const auto& cell : mesh.cells)
    for (int n = 0; n < core::PrismMesh::nodes_per_cell; ++n) {
      const int place = n % per_level, level = n - place;
      if (place < corners || is_middle_outside[mesh.section_node[cell[n]]]) continue;
      mesh.nodes[cell[n]] =
          0.5 * (mesh.nodes[cell[level + place - corners]] + mesh.nodes[cell[level + (place - corners + 1) % corners]]);
    }
}

/// Throws core::RunError where a cell is folded.
void refuse_folded(const Tool& tool, const core::PrismMesh& mesh) {
  const core::CellList cells = core::cell_list(mesh, core::prism_table());
  Eigen::Index point = 0;
  if (core::point_volumes(mesh.nodes, cells).minCoeff(&point) > 0) return;
  const core::Vector3 at = 1e3 * mesh.nodes[cells.cell(static_cast<Index>(point) / cells.table->points())[0]];
  throw core::RunError(fmt::format(
      "cells of \"{}\" fold near ({:.1f}, {:.1f}, {:.1f}) mm, where its sections change too much from one to "
      "the next: sections that change over more height, or a smaller numerics.tool_contact_size",
      tool.name, at[0], at[1], at[2]));
}

}  // namespace

SolidTool swept_tool(const Scene& scene, const State& state, Index tool) {
  const Tool& body = scene.tools[tool];
  const ToolState& round = state.tools[tool];
  SolidTool result;
  result.tool = tool;
  result.surface = std::make_shared<contact::SectionSurface>(body.profile, contact_boundaries(body), body.section);
  // Quadratic in the angle: arcs of 15 degrees are round to 1e-5 of their radius; shapes with corners need more.
  const double arc = body.section.is_round() ? M_PI / 12 : M_PI / 32;
  const auto layers = std::max(Index{1}, static_cast<Index>(std::lround(scene.solid->sector / arc)));
  result.mesh = core::sweep(round.mesh, 0, scene.solid->sector, layers, section_map(body));
  if (!body.section.is_round()) straighten_inside(round.mesh, result.mesh);
  refuse_folded(body, result.mesh);
  result.temperature = core::from_section(result.mesh, round.temperature);
  result.mass = thermal::point_masses(result.mesh.nodes, core::cell_list(result.mesh, core::prism_table()),
                                      *body.thermal, result.temperature);
  return result;
}

}  // namespace parison::forming
