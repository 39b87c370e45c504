#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/report/wall/solid_wall.hpp"

namespace parison::forming {

/// A place of the outer side in a plane through the axis.
struct MeridianPoint {
  double arc;        ///< along the outer side from the axis, m
  double r, z;       ///< m
  double thickness;  ///< m
};

/// The outer side in the half plane at an angle from the plane y = 0, rad, from the axis to the rim; empty where the
/// sector does not reach there.
std::vector<MeridianPoint> outer_meridian(const SolidState& solid, const SolidWall& wall, double angle);

/// The wall at even shares of the arc of a meridian.
struct EvenMeridian {
  double angle;  ///< rad
  std::vector<MeridianPoint> points;
};
/// At both ends of the sector and in its middle, with so many places each.
std::vector<EvenMeridian> even_meridians(const SolidState& solid, const SolidWall& wall, std::size_t places);

/// The same as a file for spreadsheets; arcs go on from one meridian to the next.
std::string meridians_csv(const SolidState& solid, const SolidWall& wall);

}  // namespace parison::forming
