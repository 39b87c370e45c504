#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// A tool of a round run in space, in the sector of Scene::solid: its section turned about the axis, with the shapes of
/// its family where it may touch the glass, going over into round ones towards its cooled sides.
SolidTool swept_tool(const Scene& scene, const State& state, Index tool);

}  // namespace parison::forming
