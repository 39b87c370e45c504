// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/contact_geometry.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "contact/unilateral/tool_gap.hpp"
#include "core/mesh/profile.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/placed_tools.hpp"
#include "remesh/surface/outline.hpp"

namespace parison::forming {

using core::dim;

namespace {

/// The projection of a point onto the surface of the tools that contain it; points outside all tools are returned as
/// they are.
Point projected_out(const PlacedTools& tools, const Point& x) {
  Point out = x;
  for (const auto& [tool, constraint] : node_constraints(tools, x, tools.near))
    if (constraint.gap < 0) out -= constraint.gap * constraint.normal;
  return out;
}

}  // namespace

std::vector<Index> surface_nodes(const core::Mesh& mesh) {
  std::vector<bool> seen(mesh.nodes.size(), false);
  std::vector<Index> nodes;
  for (const auto& edge : mesh.boundary_edges())
    for (const Index node : {edge.nodes[0], edge.nodes[2], edge.nodes[1]})
      if (!seen[node]) {
        seen[node] = true;
        nodes.push_back(node);
      }
  return nodes;
}

std::vector<flow::ToolMotion> tool_motions(const Scene& scene, const State& state, double dt) {
  std::vector<flow::ToolMotion> motions(scene.tools.size());
  for (std::size_t i = 0; i < motions.size(); ++i) motions[i].friction = scene.tools[i].friction;
  for (const auto& tool : scene.stages[state.stage].tools) {
    auto& motion = motions[tool.tool];
    if (const auto* position = std::get_if<PositionMotion>(&tool.motion))
      motion.velocity = (position->offset(state.stage_time + dt) - state.tools[tool.tool].offset) / dt;
    if (const auto* force = std::get_if<ForceMotion>(&tool.motion)) {
      motion.force = force->force.mean(state.stage_time, state.stage_time + dt);
      motion.speed_limit = force->speed_limit.mean(state.stage_time, state.stage_time + dt);
    }
  }
  return motions;
}

std::vector<bool> touching_nodes(const core::Mesh& glass) {
  std::vector<bool> flags(glass.nodes.size(), false);
  for (const Index node : contact_nodes(glass)) flags[node] = true;
  return flags;
}

std::vector<Index> contact_nodes(const core::Mesh& glass) {
  std::vector<char> seen(glass.nodes.size(), 0);
  std::vector<Index> nodes;
  nodes.reserve(3 * glass.boundary_edges().size());
  for (const auto& edge : glass.boundary_edges())
    if (glass.kind_of(edge) == BoundaryKind::contact)
      for (const Index node : edge.nodes)
        if (!std::exchange(seen[node], 1)) nodes.push_back(node);
  return nodes;
}

Eigen::VectorXd tool_gaps(const Scene& scene, const State& state, const std::vector<Index>& nodes, Index tool,
                          double reach) {
  const Body& body = scene.tools[tool];
  const core::Mesh& glass = state.glass.mesh;
  const Point displacement = state.tools[tool].offset * core::axis_direction();
  Eigen::VectorXd gaps = Eigen::VectorXd::Constant(glass.node_count(), std::numeric_limits<double>::infinity());
  contact::ToolGap gap(body.profile, contact_boundaries(body), reach);
  for (const Index node : nodes) gaps[node] = gap(glass.nodes[node] - displacement);
  return gaps;
}

Eigen::VectorXd tool_gaps(const Scene& scene, const State& state, Index tool, double reach) {
  return tool_gaps(scene, state, contact_nodes(state.glass.mesh), tool, reach);
}

double keep_beside_axis(core::Geometry geometry, core::Mesh& mesh) {
  if (geometry == core::Geometry::planar) return 0;
  double furthest = 0;
  for (Point& x : mesh.nodes)
    if (x[0] < 0) {
      furthest = std::max(furthest, -x[0]);
      x[0] = 0;
    }
  for (const auto& edge : mesh.boundary_edges()) {
    const auto& [first, last, middle] = edge.nodes;
    const double a = mesh.nodes[first][0], b = mesh.nodes[last][0];
    double& r = mesh.nodes[middle][0];
    r = std::max(r,
                 0.25 * (a + b) - 0.5 * std::sqrt(a * b));  // the least with which no point between is beyond the axis
  }
  return furthest;
}

std::function<Point(const Point&)> projector_out_of_tools(const Scene& scene, const State& state) {
  const auto tools = std::make_shared<const PlacedTools>(placed_tools(scene, state));
  return [tools](const Point& x) {
    const auto holds = [&](const PlacedTools::Tool& tool) { return core::contains(*tool.profile, x - tool.shift); };
    return std::any_of(tools->tools.begin(), tools->tools.end(), holds) ? projected_out(*tools, x) : x;
  };
}

void project_out_of_tools(const Scene& scene, const State& state, core::Mesh& mesh) {
  const PlacedTools tools = placed_tools(scene, state);
  const auto out = [&](const Point& x) { return projected_out(tools, x); };
  std::vector<Point> line(mesh.nodes.size(), Point::Zero());  // tangent of the symmetry line on which a node lies
  for (const auto& edge : mesh.boundary_edges())
    if (mesh.kind_of(edge) == BoundaryKind::symmetry)
      for (const Index node : edge.nodes)
        line[node] = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).normalized();
  const auto may_touch = touching_nodes(mesh);
  for (const Index node : surface_nodes(mesh)) {
    Point& x = mesh.nodes[node];
    if (line[node].isZero())
      x = out(x);
    else if (may_touch[node])
      x = remesh::project_along(out, x, line[node]);
  }
}

}  // namespace parison::forming
