#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>
#include <vector>

#include "core/solid/hex_mesh.hpp"

namespace parison::forming {

/// A place that a patch should pass, at its parameters.
struct PatchPlace {
  double u, v;
  core::Vector3 at;  ///< mm
};

/// A bicubic B-spline surface with knots at 0, 1, 2, ..., those inside double: continuous tangents. Between two knots
/// it has control points of its own, so that one rough place does not spread.
struct SplinePatch {
  int spans_u, spans_v;
  std::vector<core::Vector3> control;  ///< mm, (2 spans_u + 2) rows in u of (2 spans_v + 2) points
  std::vector<PatchPlace> places;
};

/// A node of a grid, mm; null where the grid does not go on beyond its border. The nodes with even numbers are corners
/// of quadratic faces.
using GridNode = std::function<const core::Vector3*(int i, int j)>;

/// The patch through the nodes (i, j) of a grid, i from 0 to `spans_u` and j to `spans_v`, both even. In the middle of
/// a line of a face it has the face's tangent, where two faces meet the mean of theirs. Tangents of a border depend on
/// nodes along it alone: patches that share it meet. Its places are the nodes, and between them points of the faces.
SplinePatch spline_patch(const GridNode& node, int spans_u, int spans_v);

/// Sews patches to a closed solid and writes it as a STEP file, in the module of gmsh. `told`: its volume, mm3, and the
/// largest distances of the patches from the nodes and from their other places, mm; or a line "refuse ...".
extern "C" void parison_sew_solid(const std::string& path, const std::vector<SplinePatch>& patches, std::string& told);

}  // namespace parison::forming
