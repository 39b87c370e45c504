#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Points at which the surface that the active tools offer to the glass has a corner, m: corners of their contact
/// boundaries, convex or re-entrant, and junctions of two tools, except those covered by another tool. New meshes have
/// nodes there.
std::vector<core::Point> tool_corners(const Scene& scene, const State& state);

}  // namespace parison::forming
