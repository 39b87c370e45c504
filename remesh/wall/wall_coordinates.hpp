#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <string>
#include <vector>

#include "remesh/transfer/overlay.hpp"
#include "remesh/wall/wall_sides.hpp"

namespace parison::remesh {

/// Coordinates in the section of a wall that is closed at the axis: `along` from the axis, 0, to the rim, 1, and
/// `across` from the inner side, 0, to the outer one, 1. Both are harmonic, so that no two places share them
/// (T. Rado, H. Kneser, 1926).
class WallCoordinates {
 public:
  /// Throws core::RunError with the reason where the section is no such wall. `section` must outlive this object.
  WallCoordinates(const core::Mesh& section, const WallSides& sides);

  /// The place in the section with these coordinates: (r, z), m, and where it lies in the mesh.
  struct Place {
    core::Point at;
    CellGrid::Found found;
  };
  Place place(double along, double across) const;
  /// Value of a nodal field of the section at a place.
  double value(const Eigen::VectorXd& field, const Place& at) const;

 private:
  const core::Mesh* section_;
  core::Mesh rectangle_;  ///< the same cells in these coordinates
  CellGrid cells_;
};

}  // namespace parison::remesh
