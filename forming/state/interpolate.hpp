#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/state/state.hpp"

namespace parison::forming {

/// What is known in the middles of two steps, `then` and `now`, at a time that is `share` of what lies between them
/// after the later one; along an exponential. Where it jumps between them, as at first contact, `now`.
double carried_on(double then, double now, double share);

/// Whether a step goes on from one of the same stage, so that what is known in their middles can be carried on.
inline bool known_at_both(const State& before, const State& after) {
  return before.stage == after.stage && before.stage_time > 0 && before.last_step > 0;
}

/// The state at `time`, s, within the step from `before` to `after` or at its end; both have the same meshes. Positions
/// as the step's straight motion has them, temperatures linear in time (second order), contact pressures carried on
/// from the middles of steps; velocities, forces, contact and sums are those of the step.
State interpolate(const State& before, const State& after, double time);

}  // namespace parison::forming
