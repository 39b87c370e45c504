#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

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

/// How near to a tool counts as filled, m.
inline constexpr double near_tool = 0.2e-3;

/// Of the area of these boundary edges, the share within `near_tool` of an active tool.
double share_near_tools(const Scene& scene, const State& state, const std::vector<Index>& edges);

/// How glass that a stage blows into a mould lies to its tools.
struct MouldFilling {
  double share = std::numeric_limits<double>::quiet_NaN();  ///< within `near_tool`, of what faces a tool
  double largest_gap = 0;                                   ///< m
  Point at = Point::Zero();                                 ///< of that gap, m
  double time = 0;                                          ///< s

  /// NaN where nothing was blown into a mould.
  bool was_blown() const { return share == share; }
};

/// The filling at the present moment. What counts is the outer surface that may touch tools, that no pressure acts on,
/// and that has a tool in front of it, along or across the axis. Nothing is blown where no pressure acts, or where less
/// than half of that surface has a tool in front: it is blown freely, as from a ring.
MouldFilling mould_filling(const Scene& scene, const State& state);

}  // namespace parison::forming
