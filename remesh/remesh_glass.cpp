// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/remesh_glass.hpp"

#include <fmt/core.h>

#include <cmath>

#include "core/mesh/tolerances.hpp"
#include "remesh/mesher/mesh_outline.hpp"
#include "remesh/surface/axis_closing.hpp"
#include "remesh/surface/curve.hpp"
#include "remesh/surface/repair/lap.hpp"
#include "remesh/surface/repair/restore_volume.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

constexpr double volume_tolerance = 2e-15;  ///< relative, at which the restored volume counts as reached
constexpr int edge_points = 4;              ///< of the quadrature rule for the shifted area
constexpr double max_defect = 0.01;         ///< relative volume a resampling may miss
constexpr double max_lap = 4e-3;            ///< of the volume, in the notch of a lap that is closed
constexpr double max_torn = 0.02;           ///< of the volume, in a piece torn off

/// The resampled surface as it may be shifted, along its normals as meshed: fixed points stay.
MovableSurface movable_surface(const Mesh& mesh, const Surface& surface) {
  const auto count = static_cast<std::size_t>(surface.outline.edge_count());
  const auto place = [&](Index node) { return node < mesh.vertex_count() ? node : node - mesh.vertex_count() + count; };
  auto normals = surface_normals(mesh, std::vector<bool>(mesh.boundaries().size(), true));
  std::vector<bool> contact(mesh.nodes.size(), false);
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    for (const Index node : edge.nodes) {
      if (surface.fixed[place(node)]) normals[node].setZero();
      contact[node] = surface.contact[place(node)];
    }
  return {[normals](const Mesh&) { return normals; },
          [contact](const Mesh&) { return contact; },
          {},
          volume_tolerance,
          edge_points};
}

std::string describe(const Point& x) {
  std::string text = "(";
  for (int k = 0; k < core::dim; ++k) text += fmt::format("{}{:.3f}", k ? ", " : "", 1e3 * x[k]);
  return text + ") mm";
}

/// A sentence about a crossing that is left.
std::string describe(const Crossings& crossings, const Surface& surface, double volume) {
  const auto at = [&](Index vertex) { return describe(surface.outline.vertices[vertex]); };
  if (crossings.left_torn)
    return fmt::format("the glass tears near {}: a piece of {:.2g} % of its volume, more than {:g} %, would come off",
                       at(crossings.first), 100 * crossings.left_volume / volume, 100 * max_torn);
  return fmt::format("the glass surface crosses itself near {} and {}, in a lap of more than {:g} of the volume",
                     at(crossings.first), at(crossings.second), max_lap);
}

/// What remesh_glass does with the old mesh, where the surface fills corners of tools or not; `result` is what is known
/// of it before.
Remeshed mesh_anew(const Mesh& old, const Criteria& criteria, const SizeField& size, CornerFilling filling,
                   const Mesher& mesher, Remeshed result) {
  Surface surface = resample(old, criteria, size, filling);
  const double volume = result.volume_before;
  const Crossings crossings = remove_crossings(
      criteria.geometry, {max_lap * volume, max_torn * volume, core::tolerance::torn_neck * core::size(old)}, surface);
  result.laps += crossings.laps, result.lap_volume += crossings.lap_volume;
  result.enclosed = crossings.enclosed, result.enclosed_volume = crossings.enclosed_volume;
  result.torn = crossings.torn, result.torn_volume = crossings.torn_volume;
  if (crossings.first >= 0) {
    result.reason = describe(crossings, surface, volume);
    return result;
  }
  MeshedOutline meshed = mesh_outline(surface.outline, old.boundaries(), size, mesher, criteria.has_skin);
  if (!meshed.reason.empty()) {
    result.reason = "the glass cannot be remeshed: " + meshed.reason;
    return result;
  }
  result.mesh = std::move(meshed.mesh);
  const double missed = core::volume(result.mesh, criteria.geometry) / (volume - result.torn_volume) - 1;
  if (!(std::abs(missed) < max_defect)) {
    result.reason = fmt::format("the resampled surface misses the glass volume by {:.2g} %", 100 * missed);
    return result;
  }
  result.volume_after =
      restore_volume(movable_surface(result.mesh, surface), criteria.geometry, result.volume_before, result.mesh);
  result.ok = true;
  return result;
}

}  // namespace

Remeshed remesh_glass(const Mesh& distorted, const Criteria& criteria, const Mesher& mesher) {
  Remeshed known;
  known.volume_before = core::volume(distorted, criteria.geometry);
  ClosedOnAxis closed{distorted};
  if (criteria.geometry == core::Geometry::axisymmetric && has_reached_axis(distorted))
    closed = close_on_axis(distorted, max_lap * known.volume_before);
  known.laps = closed.voids, known.lap_volume = closed.volume;
  const Mesh old = without_collapsed_edges(std::move(closed.mesh), criteria.contact);
  const SizeField size = size_field(old, criteria);
  known.coarsening_factor = size.coarsening_factor();
  Remeshed result = mesh_anew(old, criteria, size, CornerFilling::where_little_is_missing, mesher, known);
  // Where edges are coarse beside the body, what they miss at corners is more than the rest of the surface can give.
  if (!result.ok) {
    if (Remeshed other = mesh_anew(old, criteria, size, CornerFilling::none, mesher, known); other.ok) return other;
  }
  return result;
}

MeshedInside mesh_inside(const Mesh& mesh, const Mesh& old, const Criteria& criteria, const Mesher& mesher) {
  Outline outline;
  const auto& edges = mesh.boundary_edges();
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [first, last, middle] = edges[i].nodes;
    outline.vertices.push_back(mesh.nodes[first]);
    outline.mids.push_back(mesh.nodes[middle]);
    outline.boundary_ids.push_back(edges[i].boundary_id);
    if (i + 1 == edges.size() || edges[i + 1].nodes[0] != last) outline.loop_start.push_back(outline.edge_count());
  }
  const SizeField size = size_field(without_collapsed_edges(old, criteria.contact), criteria);
  MeshedOutline meshed = mesh_outline(outline, mesh.boundaries(), size, mesher, criteria.has_skin);
  return {std::move(meshed.mesh), std::move(meshed.reason)};
}

}  // namespace parison::remesh
