#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace parison::remesh {

using core::Index;
using core::Mesh;
using core::Point;

/// The wall behind each surface node, along the inward normal to where that leaves the body. A ray that meets a
/// symmetry boundary goes on as its mirror image: twice the way to there. Walls thicker than `reach`, m, may be left
/// out.
struct Wall {
  Eigen::VectorXd thickness;    ///< m; infinite inside and where there is none
  std::vector<Index> far_edge;  ///< boundary edge on the other side, -1 where there is none
  std::vector<Point> normal;    ///< outward, unit where there is a wall
};
Wall surface_wall(const Mesh& mesh, const std::vector<bool>& symmetry_boundaries,
                  double reach = std::numeric_limits<double>::infinity());

/// Gives each node whose value is infinite that of the nearest one whose is not.
void spread_inward(const Mesh& mesh, Eigen::VectorXd& value);

/// Wall thickness at each node, m: at the surface the distance through the body along the inward normal, inside the
/// value of the nearest surface node.
Eigen::VectorXd wall_thickness(const Mesh& mesh, const std::vector<bool>& symmetry_boundaries);

}  // namespace parison::remesh
