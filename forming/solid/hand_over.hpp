#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// Edge of cells of the glass along its wall, m, and their layers through it, for the scene's accuracy.
double solid_size(const Accuracy& accuracy);
Index solid_layers(const Accuracy& accuracy);

/// The edge with which the parison of a round run becomes a solid, m: cells that a wide tool stretches are smaller.
double solid_cell_size(const Scene& scene, const State& state);

/// The parison of a round run as a solid, with the tools of the stages from Scene::solid on: mass and heat of glass and
/// tools are those of the sector. Throws core::RunError where the parison is no wall that is closed at the axis.
SolidState hand_over(const Scene& scene, const State& state, double cell_size);

}  // namespace parison::forming
