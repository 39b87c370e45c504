#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/hex_mesh.hpp"

namespace parison::core {

/// Thickness of a wall in cells whose third coordinate goes through it, by node, m: the length of the line of edges
/// from the inner to the outer surface on which the node is.
Eigen::VectorXd wall_thickness(const HexMesh& mesh);

}  // namespace parison::core
