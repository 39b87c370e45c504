#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "remesh/sizing/size_field.hpp"

namespace parison::remesh {

/// The boundary of a body, divided into quadratic edges, body on the left: edge i goes from vertex i to the next vertex
/// of its loop through mid point i.
struct Outline {
  std::vector<core::Point> vertices, mids;  ///< m
  std::vector<core::Index> boundary_ids;    ///< boundary of each edge
  std::vector<core::Index> loop_start{0};   ///< loop k has vertices loop_start[k] ... loop_start[k+1]-1

  core::Index edge_count() const { return static_cast<core::Index>(vertices.size()); }
};

/// The last vertex of each edge.
std::vector<core::Index> edge_ends(const Outline& outline);

/// Indices of two edges that cross, or {-1, -1}. Each edge counts as two chords, through its mid point, and then as the
/// one between its ends, which the mesher takes it for.
std::pair<core::Index, core::Index> find_crossing(const Outline& outline);

/// Whether the surface of a body, symmetry lines aside, crosses itself: it has folded onto itself or been torn.
bool crosses_itself(const core::Mesh& mesh);

/// Volume that a body fills twice because its surface has passed through itself, m3, by 1024 lines across its height.
double overlap_volume(core::Geometry geometry, const core::Mesh& mesh);

/// Takes a point that lies inside a tool out to its surface; others stay to the bit. Empty where there are no tools.
using ExteriorProjection = std::function<core::Point(const core::Point&)>;

/// The same for a point of a symmetry line with unit tangent `along`: the point of the line at which it leaves the
/// tool. Coordinates across an axis-parallel line stay to the bit.
core::Point project_along(const ExteriorProjection& project_out, const core::Point& x, const core::Point& along);

/// A point on the boundary of a mesh.
struct Place {
  core::Index edge;  ///< boundary edge
  double s;          ///< parameter in [0, 1]
};

/// A part of a boundary edge within a curve.
struct CurvePart {
  Place from;     ///< where it begins
  double before;  ///< arc length on the edge before it, m; unused where the edge penetrates a tool
  double until;   ///< arc length from the curve's start to the part's end, m
  double span;    ///< interval of s, where the edge penetrates a tool and its projection is measured; otherwise 0
};

/// A boundary from one kept point to the next, as a curve over its arc length.
struct BoundaryCurve {
  std::vector<CurvePart> parts;
  bool straight;  ///< symmetry boundary
  double length() const { return parts.empty() ? 0 : parts.back().until; }
};

/// Appends the part of an edge between two values of s; where it penetrates a tool, its projection out of the tool.
void extend(const core::Mesh& mesh, const ExteriorProjection& project_out, const Place& from, double to,
            BoundaryCurve& curve);

/// The place at an arc length from the curve's start, m.
Place place_at(const core::Mesh& mesh, const BoundaryCurve& curve, double length);

/// The point at a place, m, projected out of the tools.
core::Point exterior_point(const core::Mesh& mesh, const ExteriorProjection& project_out, const Place& place);

/// Whether the boundary at a place is so deep inside a tool that it is projected out before meshing.
bool penetrates(const core::Mesh& mesh, const ExteriorProjection& project_out, const Place& place);

}  // namespace parison::remesh
