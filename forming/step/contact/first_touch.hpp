#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Velocity of the glass nodes in the middle of a step of dt, s, as predicted before it (core::dim per node, m/s): with
/// tools that touch the glass and all change their speed alike, the glass changes its own as they do.
Eigen::VectorXd carried_velocity(const Scene& scene, const State& state, double dt);

/// The time from now, s, after which glass first meets an active tool at a place of its own, as the glass moves at
/// present and the tools as they are driven; infinite where that is not within `ahead`, s. Contact that only spreads
/// along the surface from where the tool touches already is no such place.
double time_to_first_touch(const Scene& scene, const State& state, double ahead);

/// Mean speed along the axis, m/s, that a step of dt, s, begins with for a tool driven by force: that of the last step,
/// if it touched nothing in it only as far as the glass, which moves with `velocity` (core::dim per node, m/s).
double predicted_speed(const Scene& scene, const State& state, const StageTool& tool, const Eigen::VectorXd& velocity,
                       double dt);

}  // namespace parison::forming
