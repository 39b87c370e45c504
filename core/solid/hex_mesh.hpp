#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <array>
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::core {

/// Position, displacement or direction in space; the axis of tools, along which gravity acts, is the last coordinate's.
using Vector3 = Eigen::Vector3d;

/// Hexahedra with 27 nodes, each mapped from the unit cube: node i + 3 j + 9 k of a cell is at (i, j, k) / 2. Right
/// handed: the Jacobian is positive.
struct HexMesh {
  static constexpr int nodes_per_cell = 27;
  std::vector<Vector3> nodes;  ///< m
  std::vector<std::array<Index, nodes_per_cell>> cells;

  Index node_count() const { return static_cast<Index>(nodes.size()); }
  Index cell_count() const { return static_cast<Index>(cells.size()); }
};

/// A plane that nodes do not leave and along which nothing drags.
struct SymmetryPlane {
  Vector3 normal;            ///< unit
  std::vector<Index> nodes;  ///< those on another plane too
};

/// A face of a cell: where the coordinate `axis` of its cube is 0 (`end` 0) or 1.
struct HexFace {
  Index cell;
  int axis, end;
};

}  // namespace parison::core
