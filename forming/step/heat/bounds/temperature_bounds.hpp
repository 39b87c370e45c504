#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Follows, after a heat step of length dt, s, how far temperatures inside the bodies go beyond those that their
/// surface and their start have had; `dissipation` is that of the flow, W at each quadrature point.
void update_temperature_bounds(const Scene& scene, const std::vector<double>& dissipation, double dt, State& state);

}  // namespace parison::forming
