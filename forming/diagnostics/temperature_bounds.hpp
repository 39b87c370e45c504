#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/step/step_result.hpp"

namespace parison::forming {

/// Temperatures of a body's surface and start, beyond which none inside can go but by viscous heat (maximum principle),
/// and how far those of the mesh did.
struct TemperatureBounds {
  double coldest = 0, hottest = 0;       ///< K; both 0 before the first step with heat
  double undershoot = 0, overshoot = 0;  ///< of the node furthest beyond, integral over time, K s
};

/// Glass above all that can heat it, and when and where it was furthest.
struct HotGlass {
  double above = 0;               ///< K
  double r = 0, z = 0, time = 0;  ///< m; s
  Index stage = 0;
  double volume_share = 0;     ///< of the glass that was then above by more than is told
  double work = 0;             ///< that would be dissipated besides, were no glass so hot, J
  double viscous_heating = 0;  ///< by which dissipation can at most have heated a point of the glass, K
  double overshoot = 0;        ///< of any temperature of any body above the hottest of the scene at any step, K
};

/// Glass that is further above all that can heat it is told, K.
inline constexpr double told_excess = 5;

/// The highest temperature, K, that glass can have: of all bodies at the start, their cooling and the air, with what
/// dissipation has heated, K, and the error that a step may have.
double hottest_source(const Scene& scene, double viscous_heating);

/// The work, J, that a step from `state` of that length, s, and dissipation, W at each quadrature point, dissipates too
/// little because the temperatures of its flow, K at the nodes, are above the hottest source, K, and the glass too
/// soft.
double hot_work(const Scene& scene, const State& state, const Eigen::VectorXd& temperature,
                const std::vector<double>& dissipation, double source, double dt);

/// Follows the glass that is above all that can heat it.
void follow_hot_glass(const Scene& scene, const State& before, const StepResult& step, HotGlass& hot);

/// Follows how far temperatures inside a body go beyond those that its surface and its start have had; of the glass
/// with what dissipation has heated, K.
void follow_bounds(const Scene& scene, const StepResult& step, Index body, double heating, TemperatureBounds& bounds);

template <typename Visitor, typename Bounds>
void visit_bounds(Visitor visit, Bounds& bounds) {
  visit("coldest", bounds.coldest);
  visit("hottest", bounds.hottest);
  visit("undershoot", bounds.undershoot);
  visit("overshoot", bounds.overshoot);
}

template <typename Visitor, typename Glass>
void visit_hot_glass(Visitor visit, Glass& hot) {
  visit("above", hot.above);
  visit("r", hot.r);
  visit("z", hot.z);
  visit("time", hot.time);
  visit("stage", hot.stage);
  visit("volume_share", hot.volume_share);
  visit("work", hot.work);
  visit("viscous_heating", hot.viscous_heating);
  visit("overshoot", hot.overshoot);
}

}  // namespace parison::forming
