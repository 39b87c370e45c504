#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/solid/hex_mesh.hpp"

namespace parison::remesh {

using core::Index;

/// A wall of layers of hexahedra as it has moved.
struct MovedWall {
  const core::HexMesh* mesh;
  const std::vector<std::vector<Index>>* columns;  ///< nodes through the wall, from the inner side to the outer one
  const std::vector<core::HexFace>*inner, *outer, *rim;  ///< faces
  const std::vector<core::SymmetryPlane>* planes;
};

/// The least of core::least_jacobian of all cells.
double least_jacobian(const core::HexMesh& mesh);

/// Positions of the nodes, m, that leave no cell a least Jacobian below `wanted`, or those that lack least of it.
/// About bad cells nodes through the wall go back on the line between its sides, in the shares of layers; where that is
/// not enough, the ends of columns slide along the sides towards the middle of their neighbours. Columns of the rim
/// become straight where a cell there is bad, and keep their mean place.
std::vector<core::Vector3> straightened_nodes(const MovedWall& wall, double wanted);

}  // namespace parison::remesh
