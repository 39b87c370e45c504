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

  /// The place in the section with two coordinates: (r, z), m.
  core::Point place(double along, double across) const;

  /// Points of the inner or the outer side in their order from the axis to the rim.
  struct SidePoint {
    double along;
    core::Point at;  ///< (r, z), m
  };
  std::vector<SidePoint> side(SurfacePart part) const;

 private:
  const core::Mesh* section_;
  std::vector<SurfacePart> part_;  ///< by boundary edge of the section
  core::Mesh rectangle_;           ///< the same cells in these coordinates
  CellGrid cells_;
};

}  // namespace parison::remesh
