#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Unit outward normals at the nodes of a surface, the mean of those of their edges; zero inside. Only the edges of the
/// boundaries with `counts` set are taken, one flag per boundary of the mesh.
std::vector<core::Point> surface_normals(const core::Mesh& mesh, const std::vector<bool>& counts);

/// Volume swept by the surface per metre of shift along such directions, one per node, m2, by `edge_points` quadrature
/// points an edge.
double swept_area(const core::Mesh& mesh, core::Geometry geometry, const std::vector<core::Point>& directions,
                  int edge_points);

/// The surface of a mesh as it may be shifted to restore the volume.
struct MovableSurface {
  std::function<std::vector<core::Point>(const core::Mesh&)> directions;  ///< per node: unit, or zero where it stays
  std::function<std::vector<bool>(const core::Mesh&)> in_contact;         ///< per node: touches a tool
  std::function<void(core::Mesh&)> project;  ///< takes nodes out of tools after a shift; none where it is empty
  double volume_tolerance;                   ///< relative, at which the shifts end
  int edge_points;                           ///< of the quadrature rule for the area of the surface
};

/// Shifts the surface by a common distance until the mesh has the volume `target`, m3: the part without
/// contact; the whole surface where there is no such part or where it would have to move by more than 20 um and the
/// whole one by less than 1 um. Returns the volume reached.
double restore_volume(const MovableSurface& surface, core::Geometry geometry, double target, core::Mesh& mesh);

}  // namespace parison::remesh
