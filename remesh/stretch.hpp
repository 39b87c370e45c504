#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <vector>

#include "core/mesh.hpp"

namespace parison::remesh {

/// Takes a point that lies inside a tool out to its surface; others stay to the bit. Empty where there are no tools.
using Clear = std::function<core::Point(const core::Point&)>;

/// A place on the boundary of a mesh.
struct Place {
  core::Index edge;
  double s;
};

/// A piece of an edge, from a place on.
struct StretchPart {
  Place from;
  double before;  ///< arc length of the edge before it, m; not used where it dips
  double until;   ///< arc length from the stretch's start to its end, m
  double span;    ///< of s over it where the edge dips into a tool and is measured on its way out, 0 elsewhere
};

/// Boundary from one kept point to the next, within one piece, as a curve over arc length.
struct Stretch {
  std::vector<StretchPart> parts;
  bool straight;
  double length() const { return parts.empty() ? 0 : parts.back().until; }
};

/// Appends an edge between two values of s: as it is, or, where it dips into a tool, on its way out of it.
void extend(const core::Mesh& mesh, const Clear& clear, const Place& from, double to, Stretch& stretch);

/// The place after so much arc length, m.
Place place_at(const core::Mesh& mesh, const Stretch& stretch, double length);

/// The point at a place, outside the tools.
core::Point clear_point(const core::Mesh& mesh, const Clear& clear, const Place& place);

/// Whether the boundary at a place lies so deep inside a tool that it is led out before it is meshed.
bool dips(const core::Mesh& mesh, const Clear& clear, const Place& place);

}  // namespace parison::remesh
