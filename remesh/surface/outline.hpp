#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "remesh/sizing/size_field.hpp"

namespace parison::remesh {

/// The divided boundary of a body to be meshed, body on the left: edge i starts at vertex i, ends at the next one of
/// its loop and bends through mid point i.
struct Outline {
  std::vector<core::Point> vertices, mids;  ///< m
  std::vector<core::Index> boundary_ids;    ///< boundary of each edge
  std::vector<core::Index> loop_start{0};   ///< loop k holds vertices loop_start[k] ... loop_start[k+1]-1

  core::Index edge_count() const { return static_cast<core::Index>(vertices.size()); }
};

/// Last vertex of each edge.
std::vector<core::Index> edge_ends(const Outline& outline);

/// Two edges that cross, as indices, or {-1, -1}; each edge is taken as two chords through its mid point.
std::pair<core::Index, core::Index> find_crossing(const Outline& outline);

/// Takes a point that lies inside a tool out to its surface; others stay to the bit. Empty where there are no tools.
using ExteriorProjection = std::function<core::Point(const core::Point&)>;

/// A place on the boundary of a mesh.
struct Place {
  core::Index edge;
  double s;
};

/// A part of an edge, from a place on.
struct CurvePart {
  Place from;
  double before;  ///< arc length of the edge before it, m; not used where it dips
  double until;   ///< arc length from the stretch's start to its end, m
  double span;    ///< of s over it where the edge dips into a tool and is measured on its way out, 0 elsewhere
};

/// Boundary from one kept point to the next, within one boundary, as a curve over arc length.
struct BoundaryCurve {
  std::vector<CurvePart> parts;
  bool straight;
  double length() const { return parts.empty() ? 0 : parts.back().until; }
};

/// Appends an edge between two values of s: as it is, or, where it dips into a tool, on its way out of it.
void extend(const core::Mesh& mesh, const ExteriorProjection& project_out, const Place& from, double to,
            BoundaryCurve& curve);

/// The place after so much arc length, m.
Place place_at(const core::Mesh& mesh, const BoundaryCurve& curve, double length);

/// The point at a place, outside the tools.
core::Point exterior_point(const core::Mesh& mesh, const ExteriorProjection& project_out, const Place& place);

/// Whether the boundary at a place lies so deep inside a tool that it is led out before it is meshed.
bool penetrates(const core::Mesh& mesh, const ExteriorProjection& project_out, const Place& place);

}  // namespace parison::remesh
