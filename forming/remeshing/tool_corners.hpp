#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Where the outline that the active tools give the glass turns sharply, m: corners of their contact boundaries, into
/// the glass or away from it, and places where two of them meet; without those that another tool covers.
std::vector<core::Point> tool_corners(const Scene& scene, const State& state);

}  // namespace parison::forming
