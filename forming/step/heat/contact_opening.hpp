#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/interface_point.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Rate at which a contact pressure, Pa, closes the opening of a gap beside glass of this temperature, K, 1/s.
double closing_rate(const Scene& scene, const contact::GapConductance& law, double pressure, double temperature);

/// Share of a step in which a place was in contact whose gap, m, was `gap_before` and is now below `limit`.
double share_in_contact(double gap_before, double gap, double limit);

/// Sets the openings of the interface's points, and the rates at which they close under the state's contact pressures
/// at its temperatures. Nothing where no interface has the law of a gap.
void set_openings(const Scene& scene, const State& state, std::vector<core::InterfacePoint>& interface);

/// Advances the openings of the glass surface over a step, s, from `before`: where the glass is nearer to a tool than
/// the transition gap of their interface the contact goes on, or begins within the step; where it is not the contact is
/// over and the opening is zero again. The viscosity is that at the mean temperature of the step.
void advance_openings(const Scene& scene, const State& before, double dt, State& after);

}  // namespace parison::forming
