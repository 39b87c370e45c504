#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "forming/report/summary.hpp"
#include "forming/report/wall/solid_wall.hpp"

namespace parison::forming {

/// Puts what glass in space is at the end in the place of what the round parison was: glass, wall, heat and hottest
/// surfaces of tools. To be called before the flags are raised.
void put_solid(const SolidState& solid, const SolidWall& wall, Summary& summary);

/// Where a point of the profile of a container in space is.
struct MeridianPlace {
  int meridian;  ///< 0 and 2: at the ends of the sector, 1: in its middle
  double share;  ///< of its arc, from the axis to the rim
};
/// Nothing for a point between two meridians.
std::optional<MeridianPlace> meridian_place(std::size_t profile_point);

/// The quantities of a container in space. Its profile has the wall along three meridians, at both ends of the sector
/// and in its middle, one behind the other with a place that is no wall between them.
Quantities solid_quantities(const Scene& scene, const State& state, const Summary& summary, const SolidState& solid,
                            const SolidWall& wall);

}  // namespace parison::forming
