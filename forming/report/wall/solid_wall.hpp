#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// The wall of glass in space at one node of its outer side.
struct SolidWallPoint {
  Index outer, inner;                           ///< nodes
  core::Vector3 at;                             ///< m, on the outer side
  double thickness;                             ///< to the nearest place of the inner side, m
  double outer_temperature, inner_temperature;  ///< K
  double area;                                  ///< of the outer side that belongs to the node, m2, of the sector
};

/// The wall of a container in space.
struct SolidWall {
  std::vector<SolidWallPoint> points;  ///< by rising height, then angle
  double mean;                         ///< of the thickness by area of the outer side, m
  std::size_t thinnest, thickest;      ///< indices of points
  double capacity;                     ///< inside up to the rim, m3, of the whole container
  double near_tools;                   ///< share of the outer side within 0.2 mm of a tool in its place
};
SolidWall solid_wall(const SolidState& solid);

/// The space that glass takes: along the axis and from it, m.
struct SolidExtent {
  double low, high, radius;
};
SolidExtent extent_of(const SolidState& solid);
/// Of the whole container, m3.
double whole_volume(const SolidState& solid);

/// Mean temperature of glass in space by mass, K.
double mean_temperature(const SolidState& solid);

/// As a file for spreadsheets.
std::string solid_wall_csv(const SolidWall& wall);

}  // namespace parison::forming
