// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "contact/unilateral/tool_gap.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {
namespace {

/// Calls work(node, area, edge) for the three nodes of each edge of the glass surface, with the area that each stands
/// for by Simpson's rule, without symmetry boundaries.
template <typename Work>
void for_surface_nodes(const Scene& scene, const core::Mesh& mesh, const Work& work) {
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    const double length = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).norm();
    for (int i = 0; i < 3; ++i) {
      const Index node = edge.nodes[static_cast<std::size_t>(i)];
      const double around = scene.geometry == core::Geometry::planar ? 1 : 2 * M_PI * mesh.nodes[node][0];
      work(node, length * around * (i == 2 ? 4 : 1) / 6, edge);
    }
  }
}

double mean_surface_temperature(const Scene& scene, const State& state) {
  double sum = 0, area = 0;
  for_surface_nodes(scene, state.glass.mesh, [&](Index node, double part, const core::BoundaryEdge&) {
    sum += part * state.glass.temperature[node];
    area += part;
  });
  return sum / area;
}

/// Share of the surface on which the stage sets no pressure that is near a tool of the stage.
double share_near_tools(const Scene& scene, const State& state, double within) {
  const Stage& stage = scene.stages[state.stage];
  std::vector<contact::ToolGap> gaps;
  std::vector<Point> offsets;
  for (const StageTool& entry : stage.tools) {
    const Tool& tool = scene.tools[entry.tool];
    gaps.emplace_back(tool.profile, contact_boundaries(tool), 2 * within);
    offsets.push_back(state.tools[entry.tool].offset * core::axis_direction());
  }
  const core::Mesh& mesh = state.glass.mesh;
  double near = 0, whole = 0;
  for_surface_nodes(scene, mesh, [&](Index node, double part, const core::BoundaryEdge& edge) {
    if (stage.pressure.count(mesh.boundaries()[edge.boundary_id].name)) return;
    whole += part;
    for (std::size_t i = 0; i < gaps.size(); ++i)
      if (gaps[i](mesh.nodes[node] - offsets[i]) <= within) {
        near += part;
        return;
      }
  });
  return whole > 0 ? near / whole : 0;
}

double largest_force(const Scene& scene, const State& state) {
  double largest = 0;
  for (const StageTool& tool : scene.stages[state.stage].tools)
    largest = std::max(largest, std::abs(state.tools[tool.tool].end_force));
  return largest;
}

/// 1 where gravity acts along the axis, -1 where it acts against it.
double downwards(const Stage& stage) {
  return stage.gravity > 0 ? 1 : -1;
}

double lowest_place(const Stage& stage, const State& state) {
  const double down = downwards(stage);
  double most = -std::numeric_limits<double>::infinity();
  for (const Point& x : state.glass.mesh.nodes) most = std::max(most, down * x[core::dim - 1]);
  return down * most;
}

/// By how much what was measured exceeds what ends a stage, in the unit of the condition, which holds from zero on.
double excess(const Stage& stage, const EndCondition& end, double measured) {
  switch (end.kind) {
    case EndCondition::Kind::force:
      return measured - end.value * (1 - 1e-9);
    case EndCondition::Kind::filled:
    case EndCondition::Kind::surface_above:
      return measured - end.value;
    case EndCondition::Kind::surface_below:
      return end.value - measured;
    case EndCondition::Kind::lowest:
      return downwards(stage) * (measured - end.value);
  }
  return 0;
}

StageEnd reason_of(EndCondition::Kind kind) {
  switch (kind) {
    case EndCondition::Kind::force:
      return StageEnd::force;
    case EndCondition::Kind::filled:
      return StageEnd::filled;
    case EndCondition::Kind::surface_below:
      return StageEnd::surface_below;
    case EndCondition::Kind::surface_above:
      return StageEnd::surface_above;
    case EndCondition::Kind::lowest:
      return StageEnd::lowest;
  }
  return StageEnd::none;
}

/// A stage ends when its tools will be at rest within this share of the last step, or of the longest one allowed now.
constexpr double rest_tolerance = 0.02;

}  // namespace

double time_to_rest(const Scene& scene, const State& state) {
  const Stage& stage = scene.stages[state.stage];
  if (!stage.end_speed || !state.has_moved) return std::numeric_limits<double>::infinity();
  double latest = -std::numeric_limits<double>::infinity();
  for (const StageTool& tool : stage.tools) {
    if (!tool.is_driven()) continue;
    const ToolState& body = state.tools[tool.tool];
    const double excess = std::log(std::abs(body.velocity) / *stage.end_speed);  // in the middle of the last step
    if (excess <= 0 && body.slowing <= 0) continue;
    latest = std::max(latest, excess / body.slowing - 0.5 * state.last_step);
  }
  return latest;
}

double longest_stage_time(const Scene& scene, const State& state) {
  const Stage& stage = scene.stages[state.stage];
  return stage.end_time ? *stage.end_time - state.stage_start : stage.duration;
}

EndMeasure end_measure(const Scene& scene, const State& state) {
  return [&](const EndCondition& end) {
    switch (end.kind) {
      case EndCondition::Kind::force:
        return largest_force(scene, state);
      case EndCondition::Kind::filled:
        return share_near_tools(scene, state, end.within);
      case EndCondition::Kind::surface_below:
      case EndCondition::Kind::surface_above:
        return mean_surface_temperature(scene, state);
      case EndCondition::Kind::lowest:
        return lowest_place(scene.stages[state.stage], state);
    }
    return 0.0;
  };
}

StageEnd stage_end(const Scene& scene, const State& state) {
  return stage_end(scene, state, end_measure(scene, state));
}

StageEnd stage_end(const Scene& scene, const State& clock, const EndMeasure& measure) {
  const Stage& stage = scene.stages[clock.stage];
  if (clock.stage_time >= longest_stage_time(scene, clock) - same_time) return StageEnd::duration;
  if (time_to_rest(scene, clock) <= rest_tolerance * std::max(clock.last_step, clock.next_step))
    return StageEnd::tools_at_rest;
  if (clock.stage_time > 0)
    for (const EndCondition& end : stage.ends)
      if (excess(stage, end, measure(end)) >= 0) return reason_of(end.kind);
  return StageEnd::none;
}

double share_until_end(const Stage& stage, const EndMeasure& before, const EndMeasure& after) {
  double share = 1;
  for (const EndCondition& end : stage.ends) {
    const double now = excess(stage, end, after(end));
    if (now <= 0) continue;
    const double then = excess(stage, end, before(end));
    if (then < 0) share = std::min(share, then / (then - now));
  }
  return share;
}

double shortened_to_end(double dt, double beyond, double longest) {
  constexpr double bearable = 0.02, shortest = 0.1;  // of the step, or of the longest one allowed
  return beyond > bearable * std::max(dt, longest) ? std::max(dt - beyond, shortest * dt) : dt;
}

const char* name_of(StageEnd end) {
  switch (end) {
    case StageEnd::duration:
      return "duration";
    case StageEnd::tools_at_rest:
      return "tools at rest";
    case StageEnd::force:
      return "force reached";
    case StageEnd::filled:
      return "mould filled";
    case StageEnd::surface_below:
      return "surface below its temperature";
    case StageEnd::surface_above:
      return "surface above its temperature";
    case StageEnd::lowest:
      return "lowest point reached";
    case StageEnd::none:
      break;
  }
  throw std::logic_error("a stage ended without a condition");
}

}  // namespace parison::forming
