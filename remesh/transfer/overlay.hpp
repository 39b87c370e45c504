#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <limits>
#include <vector>

#include "core/mesh/uniform_grid.hpp"

namespace parison::remesh {

/// Finds the cell around a point, or those near a box.
class CellGrid {
 public:
  explicit CellGrid(const core::Mesh& mesh);

  struct Found {
    core::Index cell = -1;
    std::array<double, 2> at{};                             ///< reference coordinates, inside or on the border
    double miss = std::numeric_limits<double>::infinity();  ///< from the point to the nearest point found, m; 0 inside
  };
  /// The cell that contains x, or else the nearest one.
  Found find(const core::Point& x) const;

  /// Sets `cells` to those whose boxes meet the given one.
  void near(const core::Box& box, std::vector<core::Index>& cells) const { cells_.find(box, cells); }

 private:
  bool try_cell(core::Index cell, const core::Point& x, Found& best) const;
  bool try_ring(const core::UniformGrid::Bin& centre, int ring, const core::Point& x, Found& best) const;

  const core::Mesh& mesh_;
  core::BoxGrid cells_;
};

/// Box of a cell's nodes, widened by a tenth of its size.
core::Box cell_box(const core::Mesh& mesh, core::Index cell);

/// Right-hand side int N_i (T - T_0) dV of the L2 projection onto the new mesh, where T is the old nodal field and T_0
/// a nodal field of the new mesh near to it: where glass has folded onto itself, and where the chords of a distorted
/// cell are inverted, two old cells count, and twice a small difference does no harm. The integral runs over the
/// intersections of old and new cells, the supermesh (P. E. Farrell, M. D. Piggott, C. C. Pain, G. J. Gorman, C. R.
/// Wilson, Comput. Methods Appl. Mech. Engng 198 (2009) 2632-2642), and is exact where both cells are straight. Curved
/// cells are intersected as the triangles of their chords; old cells at the boundary are extended outward, so that no
/// part of a new cell is left out.
Eigen::VectorXd overlay_load(const core::Mesh& from, const core::Mesh& to, core::Geometry geometry,
                             const Eigen::VectorXd& nodal, const Eigen::VectorXd& near);

}  // namespace parison::remesh
