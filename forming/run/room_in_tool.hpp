#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// How much the glass is longer than the cavity of a tool, along the axis, or wider, across it; in m.
struct ExcessSize {
  double length = 0;
  bool along_axis = true;
  double z = 0;  ///< where it is wider, m
};

/// What the glass has more than the room that a tool leaves it where it is now; a length of 0 where it fits, and in
/// planar sections.
ExcessSize excess_size(const Scene& scene, const State& state, Index tool);

/// By so much of its size the glass may be larger than a tool of the next stage: steps leave distances.
inline constexpr double outgrown_from = 0.02;

/// That a parison hangs longer or wider than a tool of the next stage, as a sentence; empty where it does not. One that
/// only its weight moves does not become shorter again.
std::string outgrown_tool(const Scene& scene, const State& state);

/// "53.2 mm longer than mould" of such a size.
std::string describe(const ExcessSize& excess, const std::string& tool);

}  // namespace parison::forming
