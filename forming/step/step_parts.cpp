// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/step_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/process/clock.hpp"
#include "core/process/work_times.hpp"
#include "forming/state/interpolate.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/penetration.hpp"
#include "forming/step/heat/contact_opening.hpp"
#include "forming/step/heat/heat_step.hpp"
#include "forming/step/heat/thermal_interface.hpp"
#include "forming/step/step_control.hpp"
#include "remesh/mesher/quality.hpp"

namespace parison::forming {

namespace {

struct Plane {
  core::Point at, inward;
};

/// The planes of symmetry, each once. Boundary edges have the glass on their left.
std::vector<Plane> symmetry_planes(core::Geometry geometry, const core::Mesh& mesh) {
  constexpr double same = 1e-6;  // of an angle, and of the length of an edge
  std::vector<Plane> planes;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) != core::BoundaryKind::symmetry) continue;
    const core::Point &first = mesh.nodes[edge.nodes[0]], along = mesh.nodes[edge.nodes[1]] - first;
    const core::Point inward = core::Point(-along[1], along[0]).normalized();
    const bool on_axis = geometry == core::Geometry::axisymmetric && std::abs(inward[0]) > std::abs(inward[1]);
    const auto is_same = [&](const Plane& other) {
      return inward.dot(other.inward) > 1 - same && std::abs(other.inward.dot(first - other.at)) < same * along.norm();
    };
    if (!on_axis && std::none_of(planes.begin(), planes.end(), is_same)) planes.push_back({first, inward});
  }
  return planes;
}

/// How far the furthest node of the glass lies beyond a plane of symmetry of its own, m; the axis is none.
double depth_beyond_symmetry_planes(core::Geometry geometry, const core::Mesh& mesh) {
  double depth = 0;
  for (const Plane& plane : symmetry_planes(geometry, mesh))
    for (const core::BoundaryEdge& edge : mesh.boundary_edges())
      depth = std::max(depth, plane.inward.dot(plane.at - mesh.nodes[edge.nodes[0]]));
  return depth;
}

/// Gives how far the furthest node went beyond the axis, where it is put back, or lies beyond a plane of symmetry, m.
double move_nodes(core::Geometry geometry, const Eigen::VectorXd& velocity, double dt, core::Mesh& mesh) {
  for (Index n = 0; n < mesh.node_count(); ++n) mesh.nodes[n] += dt * flow::node_velocity(velocity, n);
  return std::max(keep_beside_axis(geometry, mesh), depth_beyond_symmetry_planes(geometry, mesh));
}

/// Forces of the tools at the end of the step: carried on from the middles of this and the one before. A tool that its
/// force alone holds back has just that force; at its speed limit it has no larger one.
void store_end_forces(const Scene& scene, const State& before, State& after) {
  const double dt = after.time - before.time, share = dt / (dt + before.last_step);
  for (std::size_t i = 0; i < after.tools.size(); ++i) {
    ToolState& tool = after.tools[i];
    tool.end_force = known_at_both(before, after) ? carried_on(before.tools[i].force, tool.force, share) : tool.force;
  }
  for (const StageTool& entry : scene.stages[after.stage].tools) {
    const auto* driven = std::get_if<ForceMotion>(&entry.motion);
    if (!driven) continue;
    ToolState& tool = after.tools[entry.tool];
    const double drive = driven->force(after.stage_time);
    const double limit = driven->speed_limit.mean(before.stage_time, after.stage_time);
    if (std::abs(tool.velocity) < (1 - same_time) * limit || std::abs(tool.end_force) > std::abs(drive))
      tool.end_force = drive;
  }
}

/// Whether the temperature of the glass is one.
bool is_above_absolute_zero(StepResult& result) {
  const GlassState& glass = result.state.glass;
  Eigen::Index coldest = 0;
  if (glass.temperature.size() == 0 || glass.temperature.minCoeff(&coldest) > 0) return true;
  const Point& at = glass.mesh.nodes[coldest];
  result.reason = fmt::format(
      "the temperature of the glass is below absolute zero at ({:.2f}, {:.2f}) mm, where its mesh "
      "is too coarse or a cell too flat for the heat that passes",
      1e3 * at[0], 1e3 * at[1]);
  return false;
}

}  // namespace

void move_bodies(const Scene& scene, double dt, StepResult& result) {
  State& state = result.state;
  if (scene.has_flow())
    result.report.off_axis =
        std::max(result.report.off_axis, move_nodes(scene.geometry, state.glass.velocity, dt, state.glass.mesh));
  for (const auto& tool : scene.stages[state.stage].tools) {
    auto& body = state.tools[tool.tool];
    body.offset += dt * body.velocity;
  }
}

bool has_no_inverted_cells(const Scene& scene, StepResult& result) {
  const core::Mesh& mesh = result.state.glass.mesh;
  if (remesh::min_quality(mesh) > 0) return true;
  const Index cell = remesh::quality(mesh).min_quality_cell;
  const Point at = mesh.nodes[mesh.cells()[cell][0]];
  result.reason = fmt::format("a cell of the glass mesh is inverted at ({:.2f}, {:.2f}) mm{}", 1e3 * at[0], 1e3 * at[1],
                              end_of_contact(scene, result.state, cell));
  return false;
}

bool step_heat(const Scene& scene, double dt, Workspace& workspace, StepResult& result) {
  if (!scene.has_heat()) return true;
  {
    const core::ScopedTimer timer(result.report.seconds["contact"]);
    result.report.interface = thermal_interface(scene, result.state);
  }
  double seconds = 0;
  const double radiation_before = core::work_times().radiation;
  HeatOutcome outcome;
  {
    const core::ScopedTimer timer(seconds);
    outcome = advance_heat(scene, result.state, result.report.interface, result.dissipation, dt, workspace);
  }
  const double radiation = core::work_times().radiation - radiation_before;
  result.report.seconds["radiation"] += radiation;
  result.report.seconds["heat"] += std::max(seconds - radiation, 0.0);
  result.reason = outcome.reason;
  result.report.heat_substeps += outcome.substeps;
  result.report.flux_mismatch = outcome.flux_mismatch;
  result.at_heat = result.state;
  return outcome.converged && is_above_absolute_zero(result);
}

void finish(const StepStart& start, State& after) {
  const Scene& scene = start.scene;
  advance_openings(scene, start.state, start.dt, after);
  after.time += start.dt;
  after.stage_time += start.dt;
  if (scene.has_flow()) store_end_forces(scene, start.state, after);
  ++after.totals.steps;
}

}  // namespace parison::forming
