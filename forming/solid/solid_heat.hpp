#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/solid/solid_state.hpp"
#include "thermal/solid/solid_step.hpp"

namespace parison::forming {

/// Conducts heat in glass and tools over dt, s, from the time of `clock`, which has the stage and the places of tools,
/// with the contact that the flow has found. Returns why it failed, empty where it did not.
std::string advance_solid_heat(const Scene& scene, const State& clock, double dt, SolidState& solid,
                               thermal::SolidStepMatrix& matrix);

/// Moves temperatures, K, by multiples of `shape`, by node, until a body has a content of heat, J.
void keep_heat(const thermal::SolidBodyView& body, double heat, const Eigen::VectorXd& shape,
               Eigen::VectorXd& temperature);

}  // namespace parison::forming
