#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/summary.hpp"
#include "forming/report/wall/solid_wall.hpp"

namespace parison::forming {

/// Puts what glass in space is at the end in the place of what the round parison was: glass, wall, heat and hottest
/// surfaces of tools. To be called before the flags are raised.
void put_solid(const SolidState& solid, const SolidWall& wall, Summary& summary);

/// The quantities of a container in space. Its profile has the wall along three meridians, at both ends of the sector
/// and in its middle, one behind the other with a place that is no wall between them.
Quantities solid_quantities(const Scene& scene, const State& state, const Summary& summary, const SolidState& solid,
                            const SolidWall& wall);

}  // namespace parison::forming
