#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Time in which a tool is active, s.
double active_time(const Scene& scene, std::size_t tool);

/// Conductivities of the glass at its first temperature, W/m/K: of its lattice, with radiation in a wall of a length,
/// m, and in thick glass.
struct Conductivities {
  double alone, limited, unlimited;
};
Conductivities conductivities(const Scene& scene, double length);

/// Heat between glass and tools as half-spaces: conductivity of the glass, W/m/K, and whether tools stay as cold as
/// they start.
struct HalfSpaces {
  double conductivity;
  bool isothermal = false;
};
/// Relative increase of the heat into a tool of one pair of half-spaces over another, for the highest conductance and
/// the whole time in which the tool is active; the tool with the most counts.
double heat_gain(const Scene& scene, const HalfSpaces& more, const HalfSpaces& less);

}  // namespace parison::forming
