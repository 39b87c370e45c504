// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/remesh_glass.hpp"

#include <fmt/core.h>

#include <cmath>

#include "core/mesh/element.hpp"
#include "remesh/mesher/mesh_outline.hpp"
#include "remesh/surface/curve.hpp"
#include "remesh/surface/lap.hpp"
#include "remesh/surface/restore_volume.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

constexpr double volume_tolerance = 2e-15;  ///< relative error of the restored volume
constexpr double max_defect = 0.01;         ///< largest relative volume error of a resampled surface
constexpr double max_lap = 1e-3;            ///< largest notch of a lap that is closed, in volumes of the body
/// Where the free surface would move by more than `max_free_shift`, m, the whole surface moves, provided that this
/// takes less than `max_whole_shift`, m.
constexpr double max_free_shift = 20e-6, max_whole_shift = 3e-6;

/// Unit normals at the surface nodes that may move, zero at the others. Nodes in contact may move if `contacts` is set.
std::vector<Point> shift_directions(const Mesh& mesh, const Surface& surface, bool contacts) {
  const auto count = static_cast<std::size_t>(surface.outline.edge_count());
  const auto place = [&](Index node) { return node < mesh.vertex_count() ? node : node - mesh.vertex_count() + count; };
  std::vector<Point> directions(mesh.nodes.size(), Point::Zero());
  for (const core::BoundaryEdge& edge : mesh.boundary_edges()) {
    constexpr std::array<double, 3> ends{0, 1, 0.5};
    for (int k = 0; k < 3; ++k) {
      const std::size_t at = place(edge.nodes[k]);
      if (surface.fixed[at] || (!contacts && surface.contact[at])) continue;
      directions[edge.nodes[k]] += core::map_edge_point(mesh, edge.nodes, core::Geometry::planar, {ends[k], 1}).normal;
    }
  }
  for (Point& direction : directions)
    if (direction.norm() > 0) direction.normalize();
  return directions;
}

/// Volume per metre of displacement along the directions, m2.
double swept_area(const Mesh& mesh, core::Geometry geometry, const std::vector<Point>& directions) {
  double area = 0;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    for (const Index node : edge.nodes) {
      if (surface.fixed[place(node)]) normals[node].setZero();
      contact[node] = surface.contact[place(node)];
    }
  return {[normals](const Mesh&) { return normals; }, [contact](const Mesh&) { return contact; }, {}, 2e-15, 4};
}

std::string describe(const Point& x) {
  std::string text = "(";
  for (int k = 0; k < core::dim; ++k) text += fmt::format("{}{:.3f}", k ? ", " : "", 1e3 * x[k]);
  return text + ") mm";
}

}  // namespace

Remeshed remesh_glass(const Mesh& distorted, const Criteria& criteria, const Mesher& mesher) {
  Remeshed result;
  result.volume_before = core::volume(distorted, criteria.geometry);
  const Mesh old = without_collapsed_edges(distorted);
  const SizeField size = size_field(old, criteria);
  result.coarsening_factor = size.coarsening_factor();
  Surface surface = resample(old, criteria, size);
  const Laps laps = close_laps(criteria.geometry, max_lap * result.volume_before, surface);
  result.laps = laps.closed;
  result.lap_volume = laps.volume;
  if (laps.first >= 0) {
    const auto at = [&](Index vertex) { return describe(surface.outline.vertices[vertex]); };
    result.reason =
        fmt::format("the glass surface crosses itself near {} and {}, in a lap of more than {:g} of the volume",
                    at(laps.first), at(laps.second), max_lap);
    return result;
  }
  MeshedOutline meshed = mesh_outline(surface.outline, old.boundaries(), size, mesher);
  if (!meshed.reason.empty()) {
    result.reason = "the glass cannot be remeshed: " + meshed.reason;
    return result;
  }
  result.mesh = std::move(meshed.mesh);
  const double missed = core::volume(result.mesh, criteria.geometry) / result.volume_before - 1;
  if (!(std::abs(missed) < max_defect)) {
    result.reason = fmt::format("the resampled surface misses the glass volume by {:.2g} %", 100 * missed);
    return result;
  }
  result.volume_after =
      restore_volume(movable_surface(result.mesh, surface), criteria.geometry, result.volume_before, result.mesh);
  result.ok = true;
  return result;
}

}  // namespace parison::remesh
