// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/process/mould_filling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/unilateral/tool_gap.hpp"
#include "core/math/numbers.hpp"
#include "core/mesh/element.hpp"
#include "forming/report/thickness_profile.hpp"
#include "forming/scene/container/crossings.hpp"

namespace parison::forming {

namespace {

void add_skin(const Scene& scene, const GlassState& glass, GlassShape& shape) {
  double sum = 0, area = 0, logarithm = 0, least = std::numeric_limits<double>::infinity();
  for (const core::BoundaryEdge& edge : glass.mesh.boundary_edges()) {
    if (glass.mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    for (const Index node : edge.nodes) least = std::min(least, glass.temperature[node]);
    for (const core::EdgeRulePoint& at : core::edge_rule(3)) {
      const core::EdgePoint point = core::map_edge_point(glass.mesh, edge.nodes, scene.geometry, at);
      double temperature = 0;
      for (std::size_t i = 0; i < 3; ++i) temperature += point.shape[i] * glass.temperature[edge.nodes[i]];
      sum += point.area * temperature;
      area += point.area;
      if (scene.has_flow()) logarithm += point.area * std::log(scene.glass.flow->viscosity(temperature));
    }
  }
  shape.skin_mean = sum / area;
  shape.skin_min = least;
  if (scene.has_flow()) shape.skin_viscosity = std::exp(logarithm / area);
}

}  // namespace

GlassShape glass_shape(const Scene& scene, const State& state) {
  GlassShape shape{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), core::none,
                   core::none, core::none};
  for (const Point& x : state.glass.mesh.nodes) {
    shape.low = std::min(shape.low, x[core::dim - 1]);
    shape.high = std::max(shape.high, x[core::dim - 1]);
  }
  if (scene.has_heat()) add_skin(scene, state.glass, shape);
  return shape;
}

int upwards(const Scene& scene, const State& state) {
  return scene.stages.at(state.stage).gravity > 0 ? -1 : 1;
}

double lowest_downwards(const Scene& scene, const State& state) {
  if (scene.stages.at(state.stage).gravity == 0) return core::none;
  double lowest = -std::numeric_limits<double>::infinity();
  for (const Point& x : state.glass.mesh.nodes) lowest = std::max(lowest, -upwards(scene, state) * x[core::dim - 1]);
  return lowest;
}

namespace {

/// The active tools of a state, each in its place.
class ActiveTools {
 public:
  ActiveTools(const Scene& scene, const State& state) {
    for (const StageTool& entry : scene.stages.at(state.stage).tools)
      tools_.push_back({&scene.tools[entry.tool].profile,
                        core::boundaries_of_kind(state.tools[entry.tool].mesh, BoundaryKind::contact),
                        state.tools[entry.tool].offset * core::axis_direction()});
  }

  /// Distance to the nearest one, by the exact profiles, m.
  double gap(const Point& x) const {
    double gap = std::numeric_limits<double>::infinity();
    for (const Placed& tool : tools_)
      gap = std::min(gap, contact::signed_gap(*tool.profile, tool.contact, x - tool.offset));
    return gap;
  }

  /// Whether one is in front of a surface with this outward normal, along the axis or across it.
  bool are_in_front(const Point& x, const Point& normal) const {
    const int along = std::abs(normal[0]) >= std::abs(normal[1]) ? 0 : 1;
    for (const Placed& tool : tools_) {
      const Point from = x - tool.offset;
      std::vector<Crossing> crossings;
      for (const core::Segment& segment : tool.profile->segments)
        if (tool.contact[segment.boundary_id]) {
          if (along == 0)
            add_crossings(segment, from[1], true, crossings);
          else
            add_crossings_along(segment, from[0], true, crossings);
        }
      for (const Crossing& crossing : crossings)
        if ((crossing.at - from[along]) * normal[along] > 0) return true;
    }
    return false;
  }

 private:
  struct Placed {
    const core::Profile* profile;
    std::vector<bool> contact;
    Point offset;
  };
  std::vector<Placed> tools_;
};

/// Boundaries of the glass that may touch tools and that the stage does not press on from the other side.
std::vector<bool> fillable(const core::Mesh& glass, const Stage& stage) {
  std::vector<bool> wanted = core::boundaries_of_kind(glass, BoundaryKind::contact);
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const auto pressure = stage.pressure.find(glass.boundaries()[i].name);
    if (pressure != stage.pressure.end() && pressure->second.max() > 0) wanted[i] = false;
  }
  return wanted;
}

}  // namespace

double share_near_tools(const Scene& scene, const State& state, const std::vector<Index>& edges) {
  const core::Mesh& mesh = state.glass.mesh;
  const ActiveTools tools(scene, state);
  double near = 0, whole = 0;
  for (const Index edge : edges)
    for (const core::EdgeRulePoint& at : core::edge_rule(3)) {
      const auto point = core::map_edge_point(mesh, mesh.boundary_edges()[edge].nodes, scene.geometry, at);
      whole += point.area;
      if (tools.gap(point.position) <= near_tool) near += point.area;
    }
  return near / whole;
}

MouldFilling mould_filling(const Scene& scene, const State& state) {
  constexpr double free_blow = 0.5;  // share of the surface that has a tool in front
  const Stage& stage = scene.stages.at(state.stage);
  if (!stage.blows() || stage.tools.empty()) return {};
  const core::Mesh& mesh = state.glass.mesh;
  const ActiveTools tools(scene, state);
  const std::vector<bool> wanted = fillable(mesh, stage);
  double near = 0, facing = 0, whole = 0;
  MouldFilling filling;
  filling.time = state.time;
  for (const Index edge : thickness_profile(mesh, scene.geometry).outer_edges) {
    if (!wanted[mesh.boundary_edges()[edge].boundary_id]) continue;
    for (const core::EdgeRulePoint& at : core::edge_rule(3)) {
      const auto point = core::map_edge_point(mesh, mesh.boundary_edges()[edge].nodes, scene.geometry, at);
      const double gap = tools.gap(point.position);
      whole += point.area;
      if (gap > near_tool && !tools.are_in_front(point.position, point.normal)) continue;
      facing += point.area;
      if (gap <= near_tool) near += point.area;
      if (gap > filling.largest_gap) filling.largest_gap = gap, filling.at = point.position;
    }
  }
  if (facing > free_blow * whole) filling.share = near / facing;
  return filling;
}

}  // namespace parison::forming
