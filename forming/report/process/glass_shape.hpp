#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Where the glass is and what its surface is like at one moment.
struct GlassShape {
  double low, high;       ///< least and greatest coordinate along the axis, m
  double skin_mean;       ///< temperature of the surface by area, K; NaN without heat, as the next two
  double skin_min;        ///< of its nodes, K
  double skin_viscosity;  ///< geometric mean by area, Pa s; NaN without heat or flow
};
GlassShape glass_shape(const Scene& scene, const State& state);

/// The coordinate of the glass that is lowest as the gravity of the present stage has it, m downwards; NaN where the
/// stage has none. The sag of a stage is its growth since the stage's start.
double lowest_downwards(const Scene& scene, const State& state);

/// 1 where the glass stands upright along the axis in the present stage, -1 where gravity acts along +axis.
int upwards(const Scene& scene, const State& state);

}  // namespace parison::forming
