// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/remesh_glass.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/mesh/element.hpp"
#include "remesh/mesher/mesh_outline.hpp"
#include "remesh/surface/curve.hpp"
#include "remesh/surface/lap.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

constexpr double volume_tolerance = 2e-15;  ///< relative, at which the shift stops
constexpr double max_defect = 0.01;         ///< relative volume a resampling may miss
constexpr double max_lap = 1e-3;            ///< of the volume, in the notch of a lap that is closed
/// Where the free surface would have to move by more than `max_free_shift` the whole one moves, if that is by less than
/// `max_whole_shift`, m.
constexpr double max_free_shift = 20e-6, max_whole_shift = 3e-6;

/// Unit normals at the surface nodes that may give way, at contacts too where wanted, zero elsewhere.
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

/// Volume swept per metre of shift, m2.
double swept_area(const Mesh& mesh, core::Geometry geometry, const std::vector<Point>& directions) {
  double area = 0;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    for (const core::EdgeRulePoint& at : core::edge_rule(4)) {
      const core::EdgePoint point = core::map_edge_point(mesh, edge.nodes, geometry, at);
      for (int k = 0; k < 3; ++k) area += point.area * point.shape[k] * point.normal.dot(directions[edge.nodes[k]]);
    }
  return area;
}

double restore_volume(Mesh& mesh, const Surface& surface, core::Geometry geometry, double target) {
  double now = core::volume(mesh, geometry);
  const std::vector<Point> free = shift_directions(mesh, surface, false), all = shift_directions(mesh, surface, true);
  const double missed = std::abs(target - now), open = swept_area(mesh, geometry, free);
  const bool everywhere =
      open <= 0 || (missed > max_free_shift * open && missed < max_whole_shift * swept_area(mesh, geometry, all));
  const std::vector<Point>& directions = everywhere ? all : free;
  for (int pass = 0; pass < 4 && std::abs(now - target) > volume_tolerance * target; ++pass) {
    const double area = swept_area(mesh, geometry, directions);
    if (!(area > 0)) break;
    const double shift = (target - now) / area;
    for (std::size_t i = 0; i < directions.size(); ++i) mesh.nodes[i] += shift * directions[i];
    now = core::volume(mesh, geometry);
  }
  return now;
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
  result.volume_after = restore_volume(result.mesh, surface, criteria.geometry, result.volume_before);
  result.ok = true;
  return result;
}

}  // namespace parison::remesh
