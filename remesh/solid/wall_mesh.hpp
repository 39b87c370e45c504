#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/solid/hex_mesh.hpp"
#include "remesh/wall/wall_coordinates.hpp"

namespace parison::remesh {

/// A wall as layers of hexahedra: i and j of a cell run along the wall, k from the inner side to the outer one.
struct WallMesh {
  core::HexMesh mesh;
  std::vector<core::HexFace> inner, outer, rim;  ///< faces of the sides and of the rim
  std::vector<core::SymmetryPlane> planes;       ///< through the axis
  std::vector<std::vector<Index>> columns;       ///< nodes through the wall, from the inner side to the outer one
};

/// How a wall is divided.
struct WallDivision {
  double size;    ///< edge of cells along the longer side of the wall, m
  Index layers;   ///< of cells through the wall
  double sector;  ///< rad: a quarter, half or whole turn, or a smaller whole part of it
};

/// Turns the section of a wall about the axis. Quarters are closed at the axis by a square of cells (an O-grid),
/// smaller sectors by cells whose side on the axis has no area. Layers get thinner towards both sides. Nodes through
/// the wall lie on the line between its sides, and on each side they go from one ring of cells to the next by equal
/// lengths: harmonic coordinates alone would bunch them at corners until cells fold.
WallMesh turn_wall(const WallCoordinates& wall, const WallDivision& division);

/// Where layers end, from the inner side, 0, to the outer one, 1: thinner towards both, as both are cold at times.
std::vector<double> layer_ends(Index layers);

}  // namespace parison::remesh
