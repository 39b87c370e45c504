// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/remeshing/remesh_criteria.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/element.hpp"
#include "core/mesh/tolerances.hpp"
#include "forming/remeshing/tool_corners.hpp"
#include "forming/state/skin_size.hpp"
#include "forming/state/start_temperature.hpp"
#include "forming/step/contact/contact_geometry.hpp"
#include "remesh/mesher/quality.hpp"
#include "remesh/sizing/recovery.hpp"
#include "remesh/surface/axis_closing.hpp"

namespace parison::forming {

namespace {

/// Smallest edge length of the mesh over numerics.skin_size.
constexpr double min_edge_fraction = 0.5;

/// Makes the sizes, m, by cell, no larger than the temperatures at the start want them; none given: any.
void add_start_field_sizes(const Scene& scene, const core::Mesh& mesh, std::vector<double>& sizes) {
  const PlacedTemperature function = scene.has_heat() ? start_function(scene, glass_body) : PlacedTemperature{};
  if (!function) return;
  const FieldMisfit found = misfit(mesh, scene.geometry, start_temperature(scene, glass_body, mesh), function);
  const std::vector<double> wanted = fitting_sizes(mesh, found);
  sizes.resize(wanted.size(), std::numeric_limits<double>::infinity());
  for (std::size_t cell = 0; cell < sizes.size(); ++cell) sizes[cell] = std::min(sizes[cell], wanted[cell]);
}

/// Edge length at each node of the surface, m, over which the logarithm of the viscosity changes by
/// numerics.viscosity_per_edge; infinite inside. A chilled skin carries most of the load of a wall, also when the tool
/// that chilled it has gone.
std::vector<double> viscosity_target_sizes(const Scene& scene, const State& state) {
  const core::Mesh& mesh = state.glass.mesh;
  const Eigen::VectorXd& temperature = state.glass.temperature;
  std::vector<double> target_sizes(mesh.nodes.size(), std::numeric_limits<double>::infinity());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    const auto& nodes = mesh.cells()[edge.cell];
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      if (std::find(edge.nodes.begin(), edge.nodes.end(), nodes[k]) == edge.nodes.end()) continue;
      const core::CellPoint at = core::map_cell_point(mesh, edge.cell, scene.geometry, core::triangle_nodes[k]);
      Point gradient = Point::Zero();
      for (std::size_t i = 0; i < nodes.size(); ++i) gradient += temperature[nodes[i]] * at.gradient[i];
      const double slope =
          std::abs(scene.glass.flow->viscosity.log_derivative(temperature[nodes[k]])) * gradient.norm();
      if (slope > 0)
        target_sizes[nodes[k]] = std::min(target_sizes[nodes[k]], scene.accuracy.viscosity_per_edge / slope);
    }
  }
  return target_sizes;
}

/// Lets a skin have such edges, m, and a mesh edges half as long.
void allow_skin(double edge, remesh::Criteria& criteria) {
  criteria.skin_size = std::min(criteria.skin_size, edge);
  criteria.min_size = std::min(criteria.min_size, min_edge_fraction * edge);
}

/// Makes the edges of open surface no longer than short and strong cooling by air wants them.
void refine_in_air(const Scene& scene, const State& state, remesh::Criteria& criteria) {
  const core::Mesh& mesh = state.glass.mesh;
  const double wanted = scene.accuracy.surface_size;
  double edge = wanted;
  for (std::size_t b = 0; b < scene.glass.boundaries.size(); ++b)
    edge = std::min(edge, surroundings_edge(scene, glass_body, b, wanted, state.stage));
  if (edge >= wanted) return;
  allow_skin(edge, criteria);
  for (const core::BoundaryEdge& boundary : mesh.boundary_edges())
    if (mesh.kind_of(boundary) != BoundaryKind::symmetry)
      for (const Index node : boundary.nodes)
        criteria.target_skin_size[node] = std::min(criteria.target_skin_size[node], edge);
}

/// Of an edge, over the length that a new mesh may have it at most.
constexpr double max_stretch = 1.5;

/// Whether an edge of the surface is longer, or turns more, than a new mesh may have it, by `max_stretch` and
/// `max_bend`: a bent edge at the end of a contact keeps the surface beside it off the tool. Not where it lies on a
/// tool, round which it may bend, or where a new mesh would have it no shorter.
bool has_worn_edges(const Scene& scene, const State& state) {
  constexpr double max_bend = 2;
  const core::Mesh& mesh = state.glass.mesh;
  const double coarsening = state.totals.remeshing.coarsening_factor,
               max_length = max_stretch * scene.accuracy.surface_size * coarsening,
               dividable = 4 * min_edge_fraction * scene.accuracy.skin_size * coarsening;
  return std::any_of(mesh.boundary_edges().begin(), mesh.boundary_edges().end(), [&](const core::BoundaryEdge& edge) {
    if (mesh.kind_of(edge) == BoundaryKind::symmetry) return false;
    const auto [first, last, middle] = edge.nodes;
    const Point before = mesh.nodes[middle] - mesh.nodes[first], after = mesh.nodes[last] - mesh.nodes[middle];
    const double length = before.norm() + after.norm();
    const bool on_tool = std::all_of(edge.nodes.begin(), edge.nodes.end(),
                                     [&](Index node) { return state.glass.contact_tool[node] >= 0; });
    const double turn = 2 * std::abs(std::atan2(before[0] * after[1] - before[1] * after[0], before.dot(after)));
    return length > max_length || (!on_tool && length > dividable && turn > max_bend * remesh::max_turn);
  });
}

/// Whether the edges on a tenth of the surface are twice as long as the viscosity wants them that has come to vary
/// below them, and longer than a new mesh would have them. Those on a tool do not count: the skin of the contact has
/// its own size.
bool has_coarse_skin(const Scene& scene, const State& state) {
  constexpr double max_share = 0.1;
  if (!scene.has_flow() || !scene.has_heat()) return false;
  const core::Mesh& mesh = state.glass.mesh;
  const std::vector<double> wanted = viscosity_target_sizes(scene, state);
  const double coarsening = state.totals.remeshing.coarsening_factor,
               shortest = max_stretch * scene.accuracy.skin_size * coarsening;
  double coarse = 0, all = 0;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    if (mesh.kind_of(edge) == BoundaryKind::symmetry) continue;
    const double length = (mesh.nodes[edge.nodes[1]] - mesh.nodes[edge.nodes[0]]).norm();
    const bool on_tool = std::all_of(edge.nodes.begin(), edge.nodes.end(),
                                     [&](Index node) { return state.glass.contact_tool[node] >= 0; });
    all += length;
    if (!on_tool && length > std::max(2 * coarsening * wanted[edge.nodes[2]], shortest)) coarse += length;
  }
  return coarse > max_share * all;
}

}  // namespace

remesh::Criteria remesh_criteria(const Scene& scene, const State& state) {
  const Accuracy& accuracy = scene.accuracy;
  const core::Mesh& mesh = state.glass.mesh;
  remesh::Criteria result;
  result.geometry = scene.geometry;
  result.surface_size = accuracy.surface_size;
  result.skin_size = accuracy.skin_size;
  constexpr double more_across = 2;  // where the stress through the wall is wanted
  result.elements_across = accuracy.elements_across * (scene.stages[state.stage].cools ? more_across : 1);
  result.growth = edge_growth;
  result.min_size = min_edge_fraction * accuracy.skin_size;
  result.straight_boundaries = core::boundaries_of_kind(mesh, BoundaryKind::symmetry);
  result.contact.assign(mesh.nodes.size(), false);
  result.has_skin = scene.has_heat();
  if (scene.has_flow() && state.glass.temperature.size() > 0)
    result.target_skin_size = viscosity_target_sizes(scene, state);
  else
    result.target_skin_size.assign(mesh.nodes.size(), std::numeric_limits<double>::infinity());
  for (Index n = 0; n < mesh.node_count(); ++n) result.contact[n] = state.glass.contact_tool[n] >= 0;
  const double size = core::size(scene.glass.profile), contact_proximity = core::tolerance::contact_proximity * size;
  if (scene.has_heat())
    for (const auto& place : scene.stages[state.stage].tools) {
      const Eigen::VectorXd gaps = tool_gaps(scene, state, place.tool, contact_proximity);
      double edge = accuracy.skin_size;
      for (const Interface& interface : scene.interfaces)
        if (interface.tool == place.tool) edge = glass_edge_at_tool(scene, interface, edge, state.stage);
      allow_skin(edge, result);
      for (Index n = 0; n < mesh.node_count(); ++n)
        if (gaps[n] < contact_proximity) result.target_skin_size[n] = std::min(result.target_skin_size[n], edge);
    }
  if (scene.has_heat()) refine_in_air(scene, state, result);
  result.min_film_thickness = scene.glass.film.min_thickness;
  result.max_cells = accuracy.max_cells;
  result.keep = tool_corners(scene, state);
  result.project_out = [project = projector_out_of_tools(scene, state),
                        depth = core::tolerance::outline_penetration * size](const Point& x) -> Point {
    const Point out = project(x);
    return (out - x).norm() > depth ? out : x;
  };
  if (state.totals.steps == 0) add_start_field_sizes(scene, mesh, result.target_cell_size);
  return result;
}

bool needs_remesh(const Scene& scene, const State& state) {
  if (state.totals.remeshing.before_step == state.totals.steps) return false;
  return remesh::min_quality(state.glass.mesh) < scene.accuracy.quality_floor ||
         (scene.geometry == core::Geometry::axisymmetric && remesh::has_reached_axis(state.glass.mesh)) ||
         remesh::crosses_itself(state.glass.mesh) || (remeshes(state) > 0 && has_worn_edges(scene, state)) ||
         has_coarse_skin(scene, state);
}

}  // namespace parison::forming
