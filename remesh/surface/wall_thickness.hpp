#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

/// The wall behind each surface node: the ray along the inward normal up to the boundary edge at which it leaves the
/// body. At a symmetry boundary the body continues as its mirror image, so the thickness is twice the distance. Walls
/// thicker than `reach`, m, may be missing, and are at nodes that `only`, where it is given, does not name.
struct Wall {
  Eigen::VectorXd thickness;    ///< at each node, m; infinite inside the body and without a wall
  std::vector<Index> far_edge;  ///< boundary edge on the other side, -1 without a wall
  std::vector<Point> normal;    ///< outward; of unit length where there is a wall
};
Wall surface_wall(const Mesh& mesh, double reach = std::numeric_limits<double>::infinity(),
                  const std::vector<bool>& only = {});

/// Replaces infinite nodal values by the value of the nearest node with a finite one.
void spread_inward(const Mesh& mesh, Eigen::VectorXd& value);

/// Wall thickness at each node for heat that leaves through the surface, m: at the surface the distance through the
/// body along the inward normal, inside that of the nearest surface node. Boundaries that no heat passes (insulated,
/// fixed) are no surface: the body goes on behind them, as behind symmetry boundaries.
Eigen::VectorXd wall_thickness(const Mesh& mesh);

}  // namespace parison::remesh
