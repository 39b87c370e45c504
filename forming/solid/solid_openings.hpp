#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "contact/solid/solid_mortar.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// Sets the openings of contacts from those of a round state, at the nearest places of its surface. Nothing where no
/// interface has the law of a gap.
void take_openings(const Scene& scene, const State& state, SolidState& solid);

/// The opening of a tool's contact at a point of it, an index into flow::SolidGlass::contact, and the rate at which it
/// closes at a temperature of the glass, K: both 0 without the law of a gap.
void set_opening(const Scene& scene, const SolidState& solid, const Interface& interface, std::size_t point,
                 double temperature, contact::ContactState& contact);

/// Advances the openings over a step, s, that the glass began as `before`, as advance_openings of round glass does:
/// with `clock` at its start, but for the tools, which it places.
void advance_openings(const Scene& scene, const State& clock, double dt, const flow::SolidGlass& before,
                      SolidState& solid);

}  // namespace parison::forming
