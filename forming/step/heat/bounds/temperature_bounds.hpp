#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Follows, after a heat step of length dt, s, how far temperatures inside the bodies go beyond those that their
/// surface and their start have had; `dissipation` is that of the flow, W at each quadrature point.
void update_temperature_bounds(const Scene& scene, const std::vector<double>& dissipation, double dt, State& state);

/// Glass that is further above all that can heat it is told, K.
inline constexpr double told_excess = 5;

/// The highest temperature, K, that glass can have: of all bodies at the start, their cooling and the air, with what
/// dissipation has heated and the error that a step may have.
double hottest_source(const Scene& scene, const State& state);

/// The work, J, that a step from `state` of that length, s, and dissipation, W at each quadrature point, dissipates too
/// little because the temperatures of its flow, K at the nodes, are above the hottest source and the glass too soft.
double hot_work(const Scene& scene, const State& state, const Eigen::VectorXd& temperature,
                const std::vector<double>& dissipation, double dt);

}  // namespace parison::forming
