#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh.hpp"

namespace parison::remesh {

/// Whether free surface of an axisymmetric body has come to the axis: a vertex of a boundary that is no symmetry line,
/// at r <= 0, away from the ends of the axis.
bool has_reached_axis(const core::Mesh& mesh);

/// A mesh whose surface has closed around the axis, and what it enclosed.
struct ClosedOnAxis {
  core::Mesh mesh;
  int voids = 0;
  double volume = 0;  ///< m3
};

/// Where free surface next to an end of the axis has come to the axis, the axis is extended to there, and what lay in
/// between is closed, up to `max_volume`, m3. Only the boundary edges of the result and their nodes are of use; its
/// cells are those of before.
ClosedOnAxis close_on_axis(core::Mesh mesh, double max_volume);

}  // namespace parison::remesh
