#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/diagnostics/extremes.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// Takes an accepted step of glass in space into account, which ended at the time of `clock`; places are those in a
/// plane through the axis.
void follow_extremes(const Scene& scene, const State& clock, const SolidState& solid, Extremes& extremes);

}  // namespace parison::forming
