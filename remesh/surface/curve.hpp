#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Smallest kink between two boundary edges at which their common vertex counts as a corner of the body, rad.
inline constexpr double corner_angle = 27 * M_PI / 180;

/// Neighbours of a boundary edge in its loop.
struct Link {
  core::Index previous, next;
  double kink;  ///< angle from the previous edge's end to this edge's start, rad; positive to the left
};
std::vector<Link> boundary_links(const core::Mesh& mesh);

/// The mesh without collapsed boundary edges: edges shorter than a hundredth of both neighbours, which arise where two
/// nodes meet in a corner of the tools, and of those that touch no tool (`contact`: whether each node does; empty: not
/// known) edges shorter than a tenth, which arise in the notch where glass has folded. The boundary stays closed and
/// the ends of boundaries are kept. Cells and nodes are not changed.
core::Mesh without_collapsed_edges(core::Mesh mesh, const std::vector<bool>& contact = {});

/// Point, m, derivative by s, unit tangent, unit normal to its right (outward of the body), and arc length from s = 0,
/// m, of a quadratic edge (first, last, mid) at s in [0, 1].
core::Point point_on(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double s);
core::Point derivative(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double s);
core::Point tangent(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double s);
core::Point outward_normal(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double s);
double arc_length(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double s);
/// At each node the sum of the outward unit normals of the edges that meet there, of the boundaries with `counts` set
/// alone (one flag per boundary); zero at other nodes.
std::vector<core::Point> normal_sums(const core::Mesh& mesh, const std::vector<bool>& counts);
/// The parameter s at which the arc length is `length`; by Newton's method.
double at_arc_length(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, double length);
/// The parameter s of the point closest to x; by the Gauss-Newton method from the closest of five points.
double closest_on(const core::Mesh& mesh, const std::array<core::Index, 3>& edge, const core::Point& x);

/// Angle between two unit tangents, rad; positive when the second turns left.
double turning(const core::Point& before, const core::Point& after);

}  // namespace parison::remesh
