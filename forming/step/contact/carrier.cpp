// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/step/contact/carrier.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "forming/flow/cells/cell_geometry.hpp"
#include "forming/step/contact/contact_geometry.hpp"

namespace parison::forming {

namespace {

/// Whether a boundary keeps the glass from moving along the axis: a fixed one, or a symmetry plane across the axis.
bool is_held_along_axis(const core::Mesh& mesh) {
  constexpr double parallel = 1e-6;  // cosine
  const auto& edges = mesh.boundary_edges();
  return std::any_of(edges.begin(), edges.end(), [&](const core::BoundaryEdge& edge) {
    const Point along = mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]];
    const bool across = std::abs(along.dot(core::axis_direction())) < (1 - parallel) * along.norm();
    const BoundaryKind kind = mesh.kind_of(edge);
    return kind == BoundaryKind::fixed || (kind == BoundaryKind::symmetry && across);
  });
}

/// Whether the same pressure acts on all of the surface; `pressure_of` gives that of a boundary, Pa.
template <typename PressureOf>
bool has_one_pressure(const core::Mesh& mesh, const PressureOf& pressure_of) {
  std::optional<double> first;
  for (const auto& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    const double pressure = pressure_of(edge.boundary_id);
    if (first.value_or(pressure) != pressure) return false;
    first = pressure;
  }
  return true;
}

/// Distance from the glass to the nearest of the stage's tools, m, and which it is.
std::pair<double, Index> nearest_tool(const Scene& scene, const State& state) {
  std::pair<double, Index> nearest{std::numeric_limits<double>::infinity(), -1};
  for (const auto& place : scene.stages[state.stage].tools)
    nearest = std::min(
        nearest, {tool_gaps(scene, state, place.tool, std::numeric_limits<double>::infinity()).minCoeff(), place.tool});
  return nearest;
}

/// How far the glass would fall as it is onto the first of the stage's tools, m, and which it is; -1 where it would
/// fall past them all. It falls by the distance to that tool again and again, and first a little, off a tool that it
/// touches with its other side.
std::pair<double, Index> first_below(const Scene& scene, const State& state) {
  constexpr double touches = 1e-6, little = 1e-4, farthest = 5;  // of the glass
  const double size = core::size(scene.glass.profile);
  const Point down = std::copysign(1.0, scene.stages[state.stage].gravity) * core::axis_direction();
  std::pair<double, Index> first{std::numeric_limits<double>::infinity(), -1};
  for (const auto& place : scene.stages[state.stage].tools) {
    State falling = state;
    const auto gap_to_tool = [&] {
      return tool_gaps(scene, falling, place.tool, std::numeric_limits<double>::infinity()).minCoeff();
    };
    const auto fall = [&](double by) {
      for (Point& node : falling.glass.mesh.nodes) node += by * down;
    };
    double fallen = 0, gap = gap_to_tool();
    if (gap <= touches * size) {
      fall(little * size);
      gap = gap_to_tool();
    }
    while (fallen < farthest * size && gap > touches * size) {
      fall(gap);
      fallen += gap;
      gap = gap_to_tool();
    }
    if (gap <= touches * size) first = std::min(first, {fallen, place.tool});
  }
  return first;
}

/// What is nearest to glass that nothing carries.
std::string nearest_sentence(const Scene& scene, const State& state) {
  if (scene.stages[state.stage].tools.empty()) return "the stage has no tools";
  if (scene.stages[state.stage].gravity != 0) {
    const auto [fall, tool] = first_below(scene, state);
    if (tool >= 0)
      return fmt::format("it would fall {:.3g} mm along the axis onto {}", 1e3 * fall, scene.tools[tool].name);
    return "it would fall past all tools";
  }
  const auto [distance, tool] = nearest_tool(scene, state);
  return fmt::format("the nearest tool, {}, is {:.3g} mm away", scene.tools[tool].name, 1e3 * distance);
}

}  // namespace

bool add_carrier(flow::Problem& problem, std::vector<bool>& active, std::optional<double> force) {
  constexpr double unlimited = 1e3;  // m/s
  const core::Mesh& mesh = *problem.mesh;
  std::vector<bool> inside(mesh.nodes.size(), true);
  for (const auto& edge : mesh.boundary_edges())
    for (const Index node : edge.nodes) inside[node] = false;
  const auto node = std::find(inside.begin() + mesh.vertex_count(), inside.end(), true);
  const bool too_many = force && static_cast<int>(flow::driven_tools(problem).size()) >= flow::max_driven_tools;
  if (node == inside.end() || too_many) return false;
  problem.tools.push_back({{}, 0, force, unlimited});
  problem.tools.back().friction.law = flow::Friction::Law::slip;
  problem.candidates.push_back({static_cast<Index>(node - inside.begin()), static_cast<Index>(problem.tools.size()) - 1,
                                core::axis_direction(), 0.0, true});
  active.push_back(true);
  if (problem.air)
    for (auto& pocket : problem.air->pockets) pocket.tool_area.push_back(0);
  return true;
}

void remove_carrier(flow::Problem& problem, flow::Solution& solution) {
  problem.candidates.pop_back();
  if (!solution.active.empty()) solution.active.pop_back();
  for (auto* values : {&solution.tool_velocity, &solution.tool_force, &solution.tool_air_force})
    if (!values->empty()) values->pop_back();
}

bool floats(const flow::Problem& problem) {
  return problem.candidates.empty() && problem.gravity == 0 && !is_held_along_axis(*problem.mesh) &&
         has_one_pressure(*problem.mesh, [&](Index id) { return problem.boundary_conditions[id].pressure; });
}

void keep_centre_of_mass(const flow::Problem& problem, flow::Solution& solution) {
  const core::Mesh& mesh = *problem.mesh;
  const Point mean = flow::integral(mesh, problem.geometry, solution.velocity) / core::volume(mesh, problem.geometry);
  const Point drift = mean.dot(core::axis_direction()) * core::axis_direction();
  for (Index n = 0; n < mesh.node_count(); ++n) solution.velocity.segment<core::dim>(core::dim * n) -= drift;
}

std::string unsupported_glass(const Scene& scene, const State& state) {
  const Stage& stage = scene.stages[state.stage];
  const core::Mesh& mesh = state.glass.mesh;
  const auto pressure_of = [&](Index id) {
    const auto found = stage.pressure.find(mesh.boundaries()[id].name);
    return found == stage.pressure.end() ? 0.0 : found->second.max_size();
  };
  const bool is_loaded = stage.gravity != 0 || !has_one_pressure(mesh, pressure_of);
  if (!scene.has_flow() || !is_loaded || stage.trapped_air || is_held_along_axis(mesh)) return "";
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(core::dim * mesh.node_count());
  const auto candidates = contact_candidates(scene, state, at_rest, scene.accuracy.initial_step);
  const bool is_carried = std::any_of(candidates.begin(), candidates.end(), [&](const auto& candidate) {
    const bool slips = scene.tools[candidate.tool].friction.law == flow::Friction::Law::slip;
    return stage.gravity == 0 || !slips || candidate.normal.dot(core::axis_direction()) * stage.gravity < 0;
  });
  if (is_carried) return "";
  return fmt::format(
      "the glass is not constrained: nothing carries it in this stage, {}; free fall is not computed, so the glass "
      "must start where it touches a tool that carries it",
      nearest_sentence(scene, state));
}

}  // namespace parison::forming
