#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/report/summary.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Gives tools that no stage has used yet, by their index, the mesh, the place and the temperatures that they have at
/// the time of the state by the case as it is now: they have stood in the air, with their cooling, since the start.
/// Throws core::RunError where their heat cannot be followed.
void renew_unused_tools(const Scene& scene, const std::vector<Index>& tools, RunOutcome& outcome);

}  // namespace parison::forming
