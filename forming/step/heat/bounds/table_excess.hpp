#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Whether any property of the scene is a table over temperature.
bool has_property_tables(const Scene& scene);

/// Follows, after a step of length dt, s, how far temperatures of the bodies lie beyond the tables of their properties
/// and by how much these are wrong then. Beyond its ends a table of conductivity, heat capacity or friction is
/// constant: the estimate is the change that it would have if it went on as at its end, or as in the mean, whichever is
/// more. The logarithm of a viscosity goes on straight: the estimate is its curvature, or that of Arrhenius' law, over
/// the excess.
void update_table_excess(const Scene& scene, double dt, State& state);

}  // namespace parison::forming
