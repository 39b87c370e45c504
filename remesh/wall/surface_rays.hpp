#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

using core::Index;
using core::Point;

/// The ray through the glass from a point of its surface along the inward normal to where it leaves the glass. At a
/// symmetry boundary the glass goes on as its mirror image: the ray is reflected there.
struct Ray {
  Point start = Point::Zero(), direction = Point::Zero();   ///< m; unit, into the glass
  double length = std::numeric_limits<double>::infinity();  ///< m; infinite where it leaves nowhere
  Point middle = Point::Zero(), end = Point::Zero();        ///< in the section, reflected, m
  Index edge = -1;                                          ///< boundary edge at its end, -1 where it leaves nowhere
  double position = 0;                                      ///< of its end on that edge, 0 to 1
  double facing = 0;                                        ///< cosine of its angle to the outward normal at its end
  int reflections = 0;

  bool ends() const { return edge >= 0; }
  /// Where it would end without reflections, m.
  Point straight_end() const { return start + length * direction; }
};

/// The ray from each surface node, by node; one that does not end for all other nodes, and for rays across the axis of
/// an axisymmetric body at more than 60 degrees to it: those go through a rod and not through a wall.
std::vector<Ray> surface_rays(const core::Mesh& mesh, core::Geometry geometry);

/// Distance from a point to the nearest of the wanted boundary edges, by their two chords, m; infinite where none is
/// wanted.
double distance_to_edges(const core::Mesh& mesh, const std::vector<bool>& wanted_edges, const Point& x);

}  // namespace parison::remesh
