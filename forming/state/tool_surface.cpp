// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/tool_surface.hpp"

#include <algorithm>

#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"

namespace parison::forming {
namespace {

/// Integral of each node's shape function over the volume, m3.
Eigen::VectorXd nodal_volumes(const core::Mesh& mesh, core::Geometry geometry) {
  Eigen::VectorXd volume = Eigen::VectorXd::Zero(mesh.node_count());
  for (Index cell = 0; cell < mesh.cell_count(); ++cell)
    for (const core::TriangleRulePoint& at : core::triangle_rule(6)) {
      const core::CellPoint point = core::map_cell_point(mesh, cell, geometry, at);
      for (std::size_t i = 0; i < 6; ++i) volume[mesh.cells()[cell][i]] += point.shape[i] * point.volume;
    }
  return volume;
}

/// Share of a straight line, with these values at its ends, that is above a limit.
double share_above(double first, double last, double limit) {
  const auto [low, high] = std::minmax(first, last);
  if (low > limit) return 1;
  return high > limit ? (high - limit) / (high - low) : 0;
}

}  // namespace

HottestPoint hottest_surface_point(const ToolState& tool) {
  HottestPoint hottest{core::none, Point::Constant(core::none)};
  if (tool.temperature.size() == 0) return hottest;
  for (const core::BoundaryEdge& edge : tool.mesh.boundary_edges()) {
    if (tool.mesh.kind_of(edge) != core::BoundaryKind::contact) continue;
    for (const Index node : edge.nodes)
      if (!(tool.temperature[node] <= hottest.temperature))
        hottest = {tool.temperature[node], tool.mesh.nodes[node] + tool.offset * core::axis_direction()};
  }
  return hottest;
}

ToolSurface::ToolSurface(const core::Mesh& mesh, core::Geometry geometry)
    : volume_(nodal_volumes(mesh, geometry)), area_(Eigen::VectorXd::Zero(mesh.node_count())) {
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) != core::BoundaryKind::contact) continue;
    double half[2] = {0, 0};
    for (const core::EdgeRulePoint& at : core::edge_rule(4)) {
      const core::EdgePoint point = core::map_edge_point(mesh, edge.nodes, geometry, at);
      for (std::size_t i = 0; i < 3; ++i) area_[edge.nodes[i]] += point.shape[i] * point.area;
      half[at.s > 0.5] += point.area;
    }
    halves_.push_back({edge.nodes[0], edge.nodes[2], half[0]});
    halves_.push_back({edge.nodes[2], edge.nodes[1], half[1]});
  }
}

ToolTemperatures ToolSurface::temperatures(const ToolState& tool, double limit) const {
  ToolTemperatures found{core::none, core::none, core::none, Point::Constant(core::none), 0};
  if (tool.temperature.size() == 0) return found;
  found.mean = volume_.dot(tool.temperature) / volume_.sum();
  if (halves_.empty()) return found;
  found.surface_mean = area_.dot(tool.temperature) / area_.sum();
  const HottestPoint hottest = hottest_surface_point(tool);
  found.surface_max = hottest.temperature;
  found.surface_max_at = hottest.at - tool.offset * core::axis_direction();
  for (const HalfEdge& half : halves_)
    found.surface_area_above +=
        half.area * share_above(tool.temperature[half.first], tool.temperature[half.last], limit);
  return found;
}

}  // namespace parison::forming
