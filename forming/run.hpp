#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene.hpp"
#include "forming/state.hpp"
#include "forming/summary.hpp"

namespace parison::forming {

struct RunOutcome {
  State state;
  RunFacts facts;
};

/// Runs a scene through all its stages, writing results and checkpoints into a new folder. A run that cannot go on says
/// why in the facts and leaves what it has.
RunOutcome run(const Scene& scene, const std::string& directory);

}  // namespace parison::forming
