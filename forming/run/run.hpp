#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>

#include "forming/report/summary.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Asked after each step whether the run is to stop there.
using StopRequest = std::function<bool()>;

/// Runs a scene through all its stages, writing results and checkpoints into a new folder. A run that cannot go on, be
/// it for a file that the system refuses, says why in the facts and leaves what it has.
RunOutcome run(const Scene& scene, const std::string& directory, const StopRequest& stop = {});

/// Continues a run in its folder from the last checkpoint, bit for bit as if it had never stopped.
RunOutcome resume(const Scene& scene, const std::string& directory, const StopRequest& stop = {});

}  // namespace parison::forming
