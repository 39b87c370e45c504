// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/balance/volume_conservation.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "contact/unilateral/tool_gap.hpp"
#include "core/mesh/element.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "forming/step/contact/edge_correction.hpp"
#include "forming/step/flow/predictor.hpp"
#include "remesh/surface/repair/restore_volume.hpp"

namespace parison::forming {

using core::dim;

namespace {

/// Time over which a volume error is removed, at least one step, s.
constexpr double volume_recovery_time = 5e-3;

/// A dilatation mode that changes the volume by less than this share of the volume per unit of dilatation is not used:
/// the contacts prevent the dilatation.
constexpr double min_response = 0.5;

/// Error of a volume that is restored, as a share of it, and points on an edge by which it is computed exactly.
constexpr double restored_volume = 4e-15;
constexpr int edge_points = 3;

/// Whether no flow has given its dilatation mode yet.
bool is_unknown(const Eigen::VectorXd& dilatation_mode) {
  return dilatation_mode.isZero(0);
}

/// Calls move(node) for the nodes whose places count for the conserved volume: those inside only where density varies.
template <typename Move>
void for_each_moved(const Scene& scene, const core::Mesh& mesh, Move&& move) {
  if (follows_density(scene))
    for (Index n = 0; n < mesh.node_count(); ++n) move(n);
  else
    for (const auto& edge : mesh.boundary_edges())
      for (const Index n : edge.nodes) move(n);
}

/// Conserved volume after straight motion at `velocity` over dt and at nodal temperatures, K, m3.
double moved_volume(const Scene& scene, const State& state, const Eigen::VectorXd& velocity, double dt,
                    const Eigen::VectorXd& temperature) {
  const core::Mesh& start = state.glass.mesh;
  core::Mesh end = start;
  for_each_moved(scene, start, [&](Index n) { end.nodes[n] = start.nodes[n] + dt * flow::node_velocity(velocity, n); });
  return conserved_volume(scene, state.glass, end, temperature);
}

/// Conserved volume gained by straight motion at `velocity` over dt, m3, in excess of dt times the integral of div v
/// over the midpoint mesh.
double volume_error(const Scene& scene, const State& state, const core::Mesh& midpoint, const Eigen::VectorXd& velocity,
                    double dt, const Expansion& expansion) {
  const core::Mesh& start = state.glass.mesh;
  const double before = conserved_volume(scene, state.glass, start, state.glass.temperature);
  const double gained = moved_volume(scene, state, velocity, dt, expansion.end_temperature) - before;
  if (!expansion.rate.empty())
    return gained - dt * before * mean_divergence(scene, state, midpoint, velocity, expansion).of_mass;
  double divergence_volume = 0;
  for (const auto& edge : midpoint.boundary_edges())
    for (const auto& rule : core::edge_rule(3)) {
      const auto at = core::map_edge_point(midpoint, edge.nodes, scene.geometry, rule);
      for (int i = 0; i < 3; ++i)
        divergence_volume += dt * at.area * at.shape[i] * at.normal.dot(flow::node_velocity(velocity, edge.nodes[i]));
    }
  return gained - divergence_volume;
}

/// Multiple of `dilatation_mode`, 1/s, with which straight motion at `velocity` over dt leads to the conserved volume
/// `target`, m3, at nodal temperatures, K, by one secant step; nothing where the mode hardly changes the volume.
std::optional<double> correction_rate(const Scene& scene, const State& state, const Eigen::VectorXd& velocity,
                                      const Eigen::VectorXd& dilatation_mode, double dt, double target,
                                      const Eigen::VectorXd& temperature) {
  const core::Mesh& start = state.glass.mesh;
  core::Mesh end = start;
  const auto volume_with = [&](double rate) {
    for_each_moved(scene, start, [&](Index n) {
      end.nodes[n] =
          start.nodes[n] + dt * (flow::node_velocity(velocity, n) + rate * flow::node_velocity(dilatation_mode, n));
    });
    return conserved_volume(scene, state.glass, end, temperature);
  };
  const double without = volume_with(0), trial = (target - without) / (dt * target);
  if (trial == 0) return 0;
  const double with = volume_with(trial), derivative = (with - without) / trial;
  if (derivative < min_response * dt * target) return std::nullopt;
  return trial + (target - with) / derivative;
}

/// Unit directions in which surface nodes may be shifted: along the normal, within symmetry planes; zero on fixed
/// boundaries.
std::vector<Point> shift_directions(const core::Mesh& mesh) {
  auto counts = core::boundaries_of_kind(mesh, BoundaryKind::symmetry);
  counts.flip();
  auto directions = remesh::surface_normals(mesh, counts);
  for (const auto& edge : mesh.boundary_edges()) {
    const BoundaryKind kind = mesh.kind_of(edge);
    const Point normal = core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, {0.5, 1}).normal;
    for (const Index node : edge.nodes) {
      if (kind == BoundaryKind::symmetry) directions[node] -= directions[node].dot(normal) * normal;
      if (kind == BoundaryKind::fixed) directions[node].setZero();
    }
  }
  return directions;
}

/// The active tool that each surface node is nearer to than `touching`, m, or inside; -1 for none.
std::vector<Index> touched_tools(const Scene& scene, const State& state, const core::Mesh& mesh, double touching) {
  const double deepest = 100 * touching;
  std::vector<Index> touched(mesh.nodes.size(), -1);
  for (const auto& place : scene.stages[state.stage].tools) {
    const Body& body = scene.tools[place.tool];
    const contact::ToolGap gap(body.profile, contact_boundaries(body), deepest);
    const Point offset = state.tools[place.tool].offset * core::axis_direction();
    for (const Index node : surface_nodes(mesh))
      if (gap(mesh.nodes[node] - offset) < touching) touched[node] = place.tool;
  }
  return touched;
}

}  // namespace

double target_volume(const Scene& scene, const State& state, double dt) {
  return state.glass.initial_volume + excess_volume(scene, state) * (1 - std::min(1.0, dt / volume_recovery_time));
}

double prescribed_dilatation_rate(const Scene& scene, const State& state, const core::Mesh& midpoint,
                                  const Eigen::VectorXd* velocity, double dt, const Expansion& expansion) {
  const double error = velocity ? volume_error(scene, state, midpoint, *velocity, dt, expansion) : 0;
  return -(excess_volume(scene, state) / std::max(dt, volume_recovery_time) + error / dt) / state.glass.initial_volume;
}

void correct_volume(const Scene& scene, const State& state, double dt, const Eigen::VectorXd& end_temperature,
                    flow::Equilibrium& equilibrium) {
  const Eigen::VectorXd& mode = equilibrium.dilatation_mode;
  if (mode.size() == 0) return;
  const Eigen::VectorXd velocity = equilibrium.response.unknowns.head(mode.size());
  const auto rate = correction_rate(scene, state, velocity, mode, dt, target_volume(scene, state, dt), end_temperature);
  if (rate) flow::add_dilatation(*rate, equilibrium);
}

double missed_volume(const Scene& scene, const State& state, const Eigen::VectorXd& velocity, double dt,
                     const Eigen::VectorXd& end_temperature) {
  const double missed = moved_volume(scene, state, velocity, dt, end_temperature) - target_volume(scene, state, dt);
  return std::abs(missed) / state.glass.initial_volume;
}

Eigen::VectorXd volume_conserving(const Scene& scene, const State& state, Eigen::VectorXd velocity, double dt,
                                  const Eigen::VectorXd& temperature) {
  const Eigen::VectorXd& mode = state.glass.dilatation_mode;
  const auto rate = correction_rate(scene, state, velocity, mode, dt, state.glass.initial_volume, temperature);
  if (rate) velocity += *rate * mode;
  return velocity;
}

void conserve_mass(const Scene& scene, const State& before, const std::vector<double>& tool_mode, double dt,
                   State& after) {
  constexpr int corrections = 3;
  if (!follows_density(scene) || is_unknown(after.glass.dilatation_mode)) return;
  const double target = target_volume(scene, before, dt);
  Eigen::VectorXd mode = after.glass.dilatation_mode;
  keep_on_symmetry(after.glass.mesh, mode);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(mode.size());
  for (int i = 0; i < corrections; ++i) {
    const auto strain = correction_rate(scene, after, rest, mode, 1, target, after.glass.temperature);
    if (!strain || std::abs(*strain) < restored_volume) return;
    for (Index n = 0; n < after.glass.mesh.node_count(); ++n)
      after.glass.mesh.nodes[n] += *strain * flow::node_velocity(mode, n);
    keep_beside_axis(scene.geometry, after.glass.mesh);
    after.glass.velocity += *strain / dt * mode;
    for (const StageTool& tool : scene.stages[after.stage].tools) {
      after.tools[tool.tool].offset += *strain * tool_mode[tool.tool];
      after.tools[tool.tool].velocity += *strain / dt * tool_mode[tool.tool];
    }
  }
}

void restore_volume(const Scene& scene, const State& state, double target, core::Mesh& mesh) {
  const double touching = core::tolerance::at_tool * core::size(scene.glass.profile);
  remesh::MovableSurface surface;
  surface.directions = shift_directions;
  surface.in_contact = [&](const core::Mesh& now) {
    std::vector<bool> in_contact;
    for (const Index tool : touched_tools(scene, state, now, touching)) in_contact.push_back(tool >= 0);
    return in_contact;
  };
  surface.project = [&](core::Mesh& now) {
    project_out_of_tools(scene, state, now);
    move_edges_out(scene, state, touched_tools(scene, state, now, touching), now);
    keep_beside_axis(scene.geometry, now);
  };
  surface.volume_tolerance = restored_volume;
  surface.edge_points = edge_points;
  remesh::restore_volume(surface, scene.geometry, target, mesh);
}

bool shift_free_surface(const Scene& scene, const State& state, double target, core::Mesh& mesh) {
  constexpr int rounds = 3;
  const double size = core::size(scene.glass.profile), near = core::tolerance::contact_after_remesh * size;
  auto directions = shift_directions(mesh);
  const auto touched = touched_tools(scene, state, mesh, near);
  for (std::size_t n = 0; n < directions.size(); ++n)
    if (touched[n] >= 0) directions[n].setZero();
  core::Mesh shifted = mesh;
  double whole = 0;  // shift, m
  for (int round = 0; round < rounds; ++round) {
    const double missing = target - core::volume(shifted, scene.geometry);
    if (std::abs(missing) <= restored_volume * target) break;
    const double area = remesh::swept_area(shifted, scene.geometry, directions, edge_points);
    whole += missing / area;
    if (!(area > 0) || std::abs(whole) > core::tolerance::whole_shift * size) return false;
    for (std::size_t n = 0; n < directions.size(); ++n) shifted.nodes[n] = mesh.nodes[n] + whole * directions[n];
  }
  mesh = std::move(shifted);
  keep_beside_axis(scene.geometry, mesh);
  return true;
}

double excess_volume(const Scene& scene, const State& state) {
  return conserved_volume(scene, state.glass, state.glass.mesh, state.glass.temperature) - state.glass.initial_volume;
}

double volume_drift(const Scene& scene, const State& state) {
  return conserved_volume(scene, state.glass, state.glass.mesh, state.glass.temperature) / state.glass.initial_volume -
         1;
}

}  // namespace parison::forming
