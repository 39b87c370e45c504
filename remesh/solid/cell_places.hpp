#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "core/solid/hex_element.hpp"

namespace parison::remesh {

using core::Index;

/// Where a point lies in a mesh: a cell and the coordinates in its cube, which may be a little beyond it.
struct CellPlace {
  Index cell;
  core::Vector3 at;
};

/// Places in a mesh, by node, of positions, m, that its nodes have moved to: no further than two cells.
std::vector<CellPlace> cell_places(const core::HexMesh& mesh, const std::vector<core::Vector3>& moved);

/// A field at those places: `components` values for each node; a node that has not moved keeps its own to the bit.
Eigen::VectorXd values_at(const core::HexMesh& mesh, const std::vector<CellPlace>& places, const Eigen::VectorXd& field,
                          Index components);

}  // namespace parison::remesh
