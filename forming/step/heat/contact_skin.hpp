#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "core/mesh/interface_point.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Adds a heat step of length dt, s, to the contacts of all tools, from the interface that it was computed on, the
/// state after it and the heat that each tool had received before it, J.
void update_contact_skins(const Scene& scene, const std::vector<core::InterfacePoint>& interface, double dt,
                          const std::vector<double>& heat_before, State& state);

/// Estimated error of the heat that a tool has exchanged, of that heat without sign: thermal::skin_error for the mean
/// time, conductance and first cells of each of its contacts. NaN where it exchanged none.
double contact_skin_error(const Scene& scene, const State& state, Index tool);

}  // namespace parison::forming
