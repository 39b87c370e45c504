#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/mesh/point.hpp"

namespace parison::forming {

/// A point in the middle of the wall.
struct MidPoint {
  core::Point position;  ///< m
  double thickness;      ///< normal to the outer side, m
  double outer;          ///< z of the outer side, m
};

/// The section of a container as a result folder has it, r and z in m, the glass on the left of its outline.
struct ContainerShape {
  std::vector<core::Point> outline;  ///< from axis to axis, or a whole loop without its first point at the end
  bool is_loop;
  std::vector<MidPoint> middle;  ///< of the wall, in the order of its outer side; empty where the glass is no wall
  double bridged;                ///< share of the middle's length in which it was joined across feet and beads
};

/// Reads contour.csv and thickness.csv; throws core::CaseError where they are missing, broken, or no container, and for
/// the results of a planar case.
ContainerShape read_container_shape(const std::string& directory);

/// Volume of the outline turned about the axis, by cones between its points, m3.
double revolved_volume(const ContainerShape& shape);

}  // namespace parison::forming
