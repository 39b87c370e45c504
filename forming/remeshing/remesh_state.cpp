// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/remeshing/remesh_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "contact/unilateral/tool_gap.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/remeshing/mesh_smoothing.hpp"
#include "forming/remeshing/named_boundary.hpp"
#include "forming/remeshing/remesh_criteria.hpp"
#include "forming/remeshing/surface_transfer.hpp"
#include "forming/state/initial_state.hpp"
#include "forming/step/balance/volume_conservation.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "remesh/mesher/quality.hpp"
#include "remesh/remesh_glass.hpp"
#include "remesh/transfer/transfer.hpp"

namespace parison::forming {

using core::dim;

namespace {

/// The old surface node nearest to a new one: among the nodes of the old cell that contains it or, where none of them
/// lies on the surface, among all.
Index nearest_surface_node(const core::Mesh& from, const std::vector<bool>& on_surface, Index cell, const Point& x) {
  Index best = -1;
  const auto consider = [&](Index node) {
    if (on_surface[node] && (best < 0 || (from.nodes[node] - x).squaredNorm() < (from.nodes[best] - x).squaredNorm()))
      best = node;
  };
  for (const Index node : from.cells()[cell]) consider(node);
  if (best < 0)
    for (Index node = 0; node < from.node_count(); ++node) consider(node);
  return best;
}

/// A tool in contact with each new surface node, from those of the old nodes: that of the nearest old surface node,
/// where the new node's gap is small too, or no wider than what a tool that grips reaches over.
std::vector<Index> carried_contact(const Scene& scene, const State& old, const std::vector<Index>& contact_tool,
                                   const remesh::Transfer& transfer, const core::Mesh& mesh) {
  const core::Mesh& from = old.glass.mesh;
  std::vector<bool> on_surface(from.nodes.size(), false);
  for (const Index node : surface_nodes(from)) on_surface[node] = true;
  std::vector<Index> tools(mesh.nodes.size(), -1);
  for (const Index node : surface_nodes(mesh)) {
    const Point& x = mesh.nodes[node];
    const Index tool = contact_tool[nearest_surface_node(from, on_surface, transfer.cell[node], x)];
    if (tool < 0) continue;
    const Body& body = scene.tools[tool];
    const auto contact = contact_boundaries(body);
    const Point local = x - old.tools[tool].offset * core::axis_direction();
    const double reach = scene.tools[tool].friction.law == flow::Friction::Law::grip
                             ? depth_of_form(scene)
                             : core::tolerance::contact_after_remesh * core::size(scene.glass.profile);
    if (contact::signed_gap(body.profile, contact, local) < reach) tools[node] = tool;
  }
  return tools;
}

/// Projects the new surface out of the tools and restores the old volume; inner nodes follow by Laplacian smoothing
/// where the quality drops. False where cells are inverted.
bool fit_surface(const Scene& scene, const State& state, core::Mesh& mesh) {
  constexpr double acceptable = 0.9;  // of the quality as meshed
  const core::Mesh made = mesh;
  project_out_of_tools(scene, state, mesh);
  restore_volume(scene, state, core::volume(state.glass.mesh, scene.geometry), mesh);
  double min_quality = remesh::min_quality(mesh);
  if (min_quality < acceptable * remesh::min_quality(made)) {
    core::Mesh followed = mesh;
    smooth_displacement(made, followed);
    const double then = remesh::min_quality(followed);
    if (then > min_quality) mesh = std::move(followed), min_quality = then;
  }
  return min_quality > 0;
}

/// A new mesh inside the surface of `mesh`, which has been fitted, again with the old volume; leaves it where there is
/// none.
void mesh_fitted_surface(const Scene& scene, const State& state, const remesh::Criteria& wanted,
                         const remesh::Mesher& mesher, core::Mesh& mesh) {
  auto inside = remesh::mesh_inside(mesh, state.glass.mesh, wanted, mesher);
  if (!inside.reason.empty()) return;
  mesh = std::move(inside.mesh);
  core::Mesh restored = mesh;
  restore_volume(scene, state, core::volume(state.glass.mesh, scene.geometry), restored);
  if (remesh::min_quality(restored) > 0) mesh = std::move(restored);
}

/// The temperature on the new mesh by L2 projection, limited to the old extremes, with the heat content of the old
/// mesh. That of the skin is carried along the surface: taken from the projection in the volume it would be off by
/// kelvins, and the heat to the tools by per cents.
void carry_temperature(const Scene& scene, const State& state, const remesh::Transfer& transfer,
                       const SurfaceTransfer& along_surface, State& next) {
  const core::Mesh &old = state.glass.mesh, &mesh = next.glass.mesh;
  const Eigen::VectorXd& temperature = state.glass.temperature;
  Eigen::VectorXd& carried = next.glass.temperature;
  if (!scene.has_heat()) {
    if (temperature.size() > 0) carried = remesh::transfer_conserving(old, mesh, scene.geometry, transfer, temperature);
    return;
  }
  const auto heat = [&](const Eigen::VectorXd& field) {
    carried = field;
    if (scene.expands()) distribute_mass(scene, state.glass, next.glass);
    return glass_heat(scene, next);
  };
  std::vector<bool> on_surface(mesh.nodes.size(), false);
  for (const Index node : contact_nodes(mesh)) on_surface[node] = true;
  const Eigen::VectorXd skin = along_surface.project(temperature);
  const auto projected = remesh::project(old, mesh, scene.geometry, transfer, temperature, on_surface, skin);
  carried = remesh::restore_content(projected, heat, glass_heat(scene, state));
}

/// A nodal field with `components` numbers per node at the nodes of the new mesh.
Eigen::VectorXd interpolate_components(const core::Mesh& old, const remesh::Transfer& transfer,
                                       const Eigen::VectorXd& field, int components) {
  const Eigen::Map<const Eigen::MatrixXd> given(field.data(), components, old.node_count());
  Eigen::MatrixXd carried(components, static_cast<Index>(transfer.cell.size()));
  for (int a = 0; a < components; ++a)
    carried.row(a) = remesh::interpolate(old, transfer, given.row(a).transpose()).transpose();
  return carried.reshaped();
}

/// The fields but the temperature on the new mesh, each by its rule.
void carry_fields(const Scene& scene, const State& state, const remesh::Transfer& transfer,
                  const SurfaceTransfer& along_surface, State& next) {
  const core::Mesh &old = state.glass.mesh, &mesh = next.glass.mesh;
  for_each_glass_field([&](const auto& field) {
    auto& values = next.glass.*field.values;
    if constexpr (std::is_same_v<std::decay_t<decltype(values)>, std::vector<Index>>) {
      if (field.transfer == TransferRule::nearest_contact)
        values = carried_contact(scene, state, state.glass.*field.values, transfer, mesh);
    } else {
      if (field.transfer == TransferRule::interpolate_along_surface && values.size() > 0)
        values = along_surface.interpolate(state.glass.*field.values);
      if (field.transfer == TransferRule::project_along_surface && values.size() > 0)
        values = along_surface.project(state.glass.*field.values);
      if (field.transfer == TransferRule::interpolate && values.size() > 0)
        values = interpolate_components(old, transfer, state.glass.*field.values, field.components);
    }
    if (field.transfer == TransferRule::reset && values.size() > 0) {
      values.resize(field.components * place_count(field.location, mesh));
      std::fill(values.begin(), values.end(), field.at_rest());
    }
  });
  next.glass.active_contacts = {};
  next.heat_couplings.clear();
  next.light = {};
}

/// Shifts the surface of the new mesh and warms the glass by what the transfer of its temperatures has left of mass and
/// heat, where density depends on temperature: either changes the other a little.
void settle_mass(const Scene& scene, const State& state, State& next) {
  constexpr int rounds = 6;
  constexpr double settled = 1e-14;
  if (!follows_density(scene)) return;
  const auto warm = [&](double by) {
    next.glass.temperature.array() += by;
    distribute_mass(scene, state.glass, next.glass);
    return scene.has_heat() ? glass_heat(scene, next) : 0;
  };
  const double wanted = excess_volume(scene, state), heat = scene.has_heat() ? glass_heat(scene, state) : 0;
  for (int round = 0; round < rounds; ++round) {
    const double missing = wanted - excess_volume(scene, next);
    if (std::abs(missing) <= settled * state.glass.initial_volume) return;
    core::Mesh mesh = next.glass.mesh;
    restore_volume(scene, state, core::volume(mesh, scene.geometry) + missing, mesh);
    if (!(remesh::min_quality(mesh) > 0)) return;
    next.glass.mesh = std::move(mesh);
    const double shifted = warm(0), capacity = warm(1) - shifted;  // J, J/K
    warm(capacity > 0 ? (heat - shifted) / capacity - 1 : -1);
  }
}

void accumulate_change(double change, double& sum, double& largest) {
  sum += change;
  largest = std::max(largest, std::abs(change));
}

/// By how much the new temperatures exceed the range of the old ones, K; 0 where they do not.
double transfer_overshoot(const State& state, const State& next) {
  const Eigen::VectorXd &old = state.glass.temperature, &now = next.glass.temperature;
  return std::max({0.0, now.maxCoeff() - old.maxCoeff(), old.minCoeff() - now.minCoeff()});
}

void accumulate(const Scene& scene, const State& state, RemeshReason why, const remesh::Remeshed& made, State& next) {
  const core::Mesh &old = state.glass.mesh, &mesh = next.glass.mesh;
  RemeshStatistics& statistics = next.totals.remeshing;
  ++statistics.count[static_cast<std::size_t>(why)];
  accumulate_change(core::volume(mesh, scene.geometry) - core::volume(old, scene.geometry), statistics.volume,
                    statistics.max_volume);
  if (scene.has_heat()) {
    accumulate_change(glass_heat(scene, next) - glass_heat(scene, state), statistics.heat, statistics.max_heat);
    statistics.transfer_overshoot = std::max(statistics.transfer_overshoot, transfer_overshoot(state, next));
  }
  statistics.coarsening_factor = std::max(statistics.coarsening_factor, made.coarsening_factor);
  statistics.laps += made.laps;
  statistics.lap_volume += made.lap_volume;
  statistics.enclosed += made.enclosed;
  statistics.enclosed_volume += made.enclosed_volume;
  statistics.torn += made.torn;
  statistics.torn_volume += made.torn_volume;
  const auto quality = remesh::quality(mesh);
  statistics.min_quality = std::min(statistics.min_quality, quality.min);
  statistics.min_median = std::min(statistics.min_median, quality.median);
  statistics.before_step = why == RemeshReason::stage_start ? -1 : next.totals.steps;
}

/// Nodes in contact with a tool that the stage takes away.
std::vector<Index> nodes_left_by_tools(const Stage& stage, const State& state) {
  std::vector<Index> nodes;
  for (Index n = 0; n < state.glass.mesh.node_count(); ++n)
    if (state.glass.contact_tool[n] >= 0 && !stage.uses(state.glass.contact_tool[n])) nodes.push_back(n);
  return nodes;
}

/// Whether two stages have the same tools. Where they have not, the machine has opened the cavities.
bool same_tools(const Stage& a, const Stage& b) {
  const auto active = [](const Stage& stage) {
    std::set<Index> tools;
    for (const StageTool& tool : stage.tools) tools.insert(tool.tool);
    return tools;
  };
  return active(a) == active(b);
}

}  // namespace

RemeshedState remesh_state(const Scene& scene, const State& state, RemeshReason why, const remesh::Mesher& mesher) {
  RemeshedState result;
  const remesh::Criteria wanted = remesh_criteria(scene, state);
  auto made = remesh::remesh_glass(state.glass.mesh, wanted, mesher);
  if (!made.ok) {
    result.reason = made.reason;
    return result;
  }
  result.state = state;
  State& next = result.state;
  core::Mesh& mesh = next.glass.mesh;
  mesh = std::move(made.mesh);
  keep_beside_axis(scene.geometry, mesh);
  if (!fit_surface(scene, state, mesh)) mesh_fitted_surface(scene, state, wanted, mesher, mesh);
  if (!(remesh::min_quality(mesh) > 0)) {
    result.reason = "the new mesh has inverted cells where it is projected out of a tool";
    return result;
  }
  const auto transfer = remesh::make_transfer(state.glass.mesh, mesh);
  const SurfaceTransfer along_surface(state.glass.mesh, mesh, scene.geometry);
  carry_fields(scene, state, transfer, along_surface, next);
  if (!scene.expands()) distribute_mass(scene, state.glass, next.glass);
  carry_temperature(scene, state, transfer, along_surface, next);
  if (scene.expands()) distribute_mass(scene, state.glass, next.glass);
  settle_mass(scene, state, next);
  accumulate(scene, state, why, made, next);
  result.ok = true;
  return result;
}

namespace {

/// How far a place lies along gravity, m.
double fallen_to(const Stage& stage, const Point& at) {
  return stage.gravity > 0 ? at[dim - 1] : -at[dim - 1];
}

}  // namespace

void place_under_glass(const Scene& scene, Index stage, double lowest, State& state) {
  const Stage& cooling = scene.stages[stage];
  if (!cooling.cools || cooling.gravity == 0) return;
  for (const StageTool& entry : cooling.tools) {
    if (first_use(scene, entry.tool) != stage) continue;
    double top = std::numeric_limits<double>::infinity();
    for (const core::Segment& segment : scene.tools[entry.tool].profile.segments)
      top = std::min({top, fallen_to(cooling, segment.start), fallen_to(cooling, segment.end)});
    state.tools[entry.tool].offset = cooling.gravity > 0 ? lowest - top : top - lowest;
  }
}

State start_stage(const Scene& scene, const State& state, Index stage) {
  State next = state;
  next.stage = stage;
  next.stage_time = 0;
  next.stage_start = state.time;
  next.has_moved = false;
  next.last_step = 0;
  next.moves_smoothly = false;
  next.heat_couplings.clear();
  next.light = {};
  if (!scene.stages[stage].trapped_air || !same_tools(scene.stages[state.stage], scene.stages[stage]))
    next.cavity_air = {};
  const std::vector<Index> left = nodes_left_by_tools(scene.stages[stage], state);
  for_each_glass_field([&](const auto& field) {
    auto& values = next.glass.*field.values;
    if (field.stage_start == StageStart::reset) std::fill(values.begin(), values.end(), field.at_rest());
    if (field.stage_start == StageStart::reset_without_tool && values.size() > 0)
      for (const Index n : left) values[n] = field.at_rest();
  });
  next.glass.active_contacts = {};
  for (ToolState& tool : next.tools) tool.velocity = tool.slowing = tool.force = tool.end_force = 0;
  double lowest = -std::numeric_limits<double>::infinity();
  for (const Point& x : state.glass.mesh.nodes) lowest = std::max(lowest, fallen_to(scene.stages[stage], x));
  place_under_glass(scene, stage, lowest, next);
  for (const auto& named : scene.stages[stage].named_boundaries) name_boundary(scene, state, named, next.glass.mesh);
  return next;
}

}  // namespace parison::forming
