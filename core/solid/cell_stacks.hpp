#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/solid/hex_mesh.hpp"

namespace parison::core {

/// The cells of a wall in layers, in the order of their third coordinate: a stack for each cell whose low side no other
/// cell shares.
std::vector<std::vector<Index>> cell_stacks(const HexMesh& mesh);

}  // namespace parison::core
