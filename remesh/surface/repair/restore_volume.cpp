// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh/surface/repair/restore_volume.hpp"

#include <algorithm>
#include <cmath>

#include "core/mesh/element.hpp"
#include "core/mesh/tolerances.hpp"
#include "remesh/surface/curve.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

namespace {

/// Rounds; after the first `max_free_rounds` the whole surface is shifted.
constexpr int max_rounds = 26, max_free_rounds = 20;

void shift(double distance, const std::vector<Point>& directions, Mesh& mesh) {
  for (std::size_t n = 0; n < directions.size(); ++n) mesh.nodes[n] += distance * directions[n];
}

/// The directions without those of nodes in contact.
std::vector<Point> free_directions(std::vector<Point> directions, const std::vector<bool>& in_contact) {
  for (std::size_t n = 0; n < directions.size(); ++n)
    if (in_contact[n]) directions[n].setZero();
  return directions;
}

}  // namespace

double swept_area(const Mesh& mesh, core::Geometry geometry, const std::vector<Point>& directions, int edge_points) {
  double area = 0;
  for (const core::BoundaryEdge& edge : mesh.boundary_edges())
    for (const core::EdgeRulePoint& at : core::edge_rule(edge_points)) {
      const core::EdgePoint point = core::map_edge_point(mesh, edge.nodes, geometry, at);
      for (int k = 0; k < 3; ++k) area += point.area * point.shape[k] * point.normal.dot(directions[edge.nodes[k]]);
    }
  return area;
}

std::vector<Point> surface_normals(const Mesh& mesh, const std::vector<bool>& counts) {
  std::vector<Point> normals = normal_sums(mesh, counts);
  for (Point& normal : normals)
    if (normal.norm() > 0) normal.normalize();
  return normals;
}

double restore_volume(const MovableSurface& surface, core::Geometry geometry, double target, Mesh& mesh) {
  // The whole surface is shifted where the free part would have to move far and the whole one by a little only.
  const double size = core::size(mesh), max_shift = core::tolerance::shift * size;
  const double max_free_shift = core::tolerance::free_shift * size,
               max_whole_shift = core::tolerance::whole_shift * size;
  bool everywhere = false;
  double volume = core::volume(mesh, geometry);
  for (int round = 0; round < max_rounds && std::abs(target - volume) > surface.volume_tolerance * target; ++round) {
    const double defect = target - volume;
    const auto whole = surface.directions(mesh);
    const double whole_area = swept_area(mesh, geometry, whole, surface.edge_points);
    if (!everywhere) {
      const auto free = free_directions(whole, surface.in_contact(mesh));
      const double free_area = swept_area(mesh, geometry, free, surface.edge_points);
      const bool too_far =
          std::abs(defect) > max_free_shift * free_area && std::abs(defect) < max_whole_shift * whole_area;
      everywhere = free_area <= 0 || too_far || round >= max_free_rounds;
      if (!everywhere) {
        shift(std::clamp(defect / free_area, -max_shift, max_shift), free, mesh);
        if (surface.project) surface.project(mesh);
      }
    }
    if (everywhere) {
      if (whole_area <= 0) break;
      shift(defect / whole_area, whole, mesh);
    }
    volume = core::volume(mesh, geometry);
  }
  return volume;
}

}  // namespace parison::remesh
