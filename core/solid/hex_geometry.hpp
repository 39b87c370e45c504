#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <vector>

#include "core/solid/hex_element.hpp"

namespace parison::core {

/// Positions of a cell's nodes and of a face's, m, in their orders.
HexNodes cell_nodes(const HexMesh& mesh, Index cell);
HexFaceNodes face_nodes(const HexMesh& mesh, const HexFace& face);
/// The numbers of a face's nodes in the mesh, in the order of hex_face_nodes.
std::array<Index, 9> face_node_numbers(const HexMesh& mesh, const HexFace& face);

/// Volume of each cell, m3, exact for its map.
Eigen::VectorXd cell_volumes(const HexMesh& mesh);
/// The least Jacobian of a cell at its nodes and Gauss points over that at its centre: not positive where it is folded.
/// Nodes at which an edge has no length, as on the axis of a wedge, do not count.
double least_jacobian(const HexMesh& mesh, Index cell);

}  // namespace parison::core
