#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/interface_point.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Largest change of the glass surface's temperature between two states with the same mesh, K. Nodes on which a tool's
/// temperature is as good as imposed do not count: where the conductance h is so large that the contact relaxes, in
/// k rho c/h^2, within the first step of a stage, a touch makes a jump that no shorter step resolves.
double surface_temperature_change(const Scene& scene, const State& before, const State& after,
                                  const std::vector<core::InterfacePoint>& interface);

}  // namespace parison::forming
