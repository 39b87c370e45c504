#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Kink between two boundary edges from which their common vertex counts as a corner of the body, rad.
inline constexpr double corner_angle = 27 * M_PI / 180;

/// How a boundary edge meets its neighbours in its loop.
struct Link {
  core::Index previous, next;
  double kink;  ///< angle from the previous edge's end to this edge's start, rad; positive to the left
};
std::vector<Link> boundary_links(const core::Mesh& mesh);

/// The mesh without boundary edges whose ends have met, as two nodes do that a corner of the tools has caught; the
/// boundary stays closed, ends of boundaries stay. Cells and nodes are left as they are.
core::Mesh without_collapsed_edges(core::Mesh mesh);

/// Point, unit tangent and arc length from s = 0 of a quadratic edge (first, last, mid) at s in [0, 1].
core::Point point_on(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double s);
core::Point tangent(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double s);
double arc_length(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double s);
/// s where the arc length reaches `length`.
double at_arc_length(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double length);
/// s of the point closest to x.
double closest_on(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, const core::Point& x);

/// Angle between two unit tangents, rad; positive when the second turns left.
double turning(const core::Point& before, const core::Point& after);

}  // namespace parison::remesh
