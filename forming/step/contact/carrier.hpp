#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "forming/flow/solution.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Glass that no tool holds along the axis is held there by a carrier: a tool that is not in the scene and has one node
/// inside the glass, so that the flow equations have a solution. Driven by the `force` given, N, its velocity follows
/// from the balance; without one it is at rest. False, and nothing added, where as many tools as possible are driven
/// already.
bool add_carrier(flow::Problem& problem, std::vector<bool>& active, std::optional<double> force);
/// Takes it away from the problem and its solution.
void remove_carrier(flow::Problem& problem, flow::Solution& solution);

/// Whether the glass floats: nothing can touch it or holds it, and neither gravity nor different pressures move it, so
/// that surface tension alone forms it about its centre of mass.
bool floats(const flow::Problem& problem);
/// Takes the velocity of the centre of mass along the axis from all velocities.
void keep_centre_of_mass(const flow::Problem& problem, flow::Solution& solution);

/// A sentence where nothing carries the glass of `state` against gravity or air; empty otherwise.
std::string unsupported_glass(const Scene& scene, const State& state);

}  // namespace parison::forming
