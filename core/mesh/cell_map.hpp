#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/cell_batch.hpp"

namespace parison::core {

/// The quadratic map of a cell in hierarchical form, m: the chords from vertex 0 to vertices 1 and 2, and the offset of
/// each mid-side node from the middle of its chord.
struct CellMap {
  Point origin, u, v;
  std::array<Point, 3> mid_side_offset;
};
CellMap cell_map(const Mesh& mesh, Index cell);

/// Reference coordinates (a, b) of x in the triangle of the chords: those in the cell where its edges are straight.
std::array<double, 2> chord_coordinates(const CellMap& map, const Point& x);

/// Reference coordinates (a, b) of x by Newton's method from chord_coordinates, to about 1e-14; outside [0, 1] when x
/// is outside the cell. The iteration ends where they exceed 1e3 or are not finite: the map cannot be inverted there.
std::array<double, 2> invert(const CellMap& map, const Point& x);

/// Batches of points that are inverted together.
inline constexpr int point_batches = 2;
/// Points, m, or their reference coordinates, [batch][component].
using PointBatches = std::array<std::array<VectorizedArray, dim>, point_batches>;
/// The same for eight points of one cell, which take the same number of Newton steps.
void invert(const CellMap& map, const PointBatches& x, PointBatches& reference);

/// Reference coordinates of x in a cell of a mesh.
std::array<double, 2> invert_cell_map(const Mesh& mesh, Index cell, const Point& x);

}  // namespace parison::core
