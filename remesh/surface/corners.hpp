#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <vector>

#include "remesh/surface/curve.hpp"
#include "remesh/surface/resample.hpp"

namespace parison::remesh {

/// The parameter at which an old edge passes a tool corner, and the position of the vertex placed there, m.
struct Kept {
  double s;
  core::Point vertex;
};

/// An old edge that counts as filling a tool corner: the surface follows both walls, which it meets there at s.
struct FilledEdge {
  double s;
  core::Point corner;
};

/// What the surface does at the tool corners: where it gets a vertex, by old edge, and the edges that fill a corner.
struct Corners {
  std::map<core::Index, Kept> kept;
  std::map<core::Index, FilledEdge> filled;
};

/// Whether the first vertex of an old edge keeps its exact position: an end of a boundary or a corner of the body.
bool is_fixed(const core::Mesh& old, const std::vector<Link>& links, core::Index edge);

/// What the new surface does at the tool corners `criteria.keep`. Where the old one counts as filling a corner the
/// vertex lies in it: how much of it a mesh fills would be chance, and with it where all glass beside the corner lies.
Corners find_corners(const core::Mesh& old, const Criteria& criteria, const SizeField& size, CornerFilling filling);

}  // namespace parison::remesh
