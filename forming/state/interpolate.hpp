#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/state.hpp"

namespace parison::forming {

/// The state at `time`, s, within the step from `before` to `after`, which have the same meshes: positions as the
/// step's straight motion has them, temperatures linear in time (second order); velocities, forces, contact and sums
/// are those of the step.
State interpolate(const State& before, const State& after, double time);

}  // namespace parison::forming
