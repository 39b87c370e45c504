#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/report/error_bars.hpp"
#include "forming/run/run.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// What a coarse run is run with, and where.
struct CoarseCase {
  std::string file, accuracy, directory;
  std::vector<std::string> overrides;
};

/// The coarse run of a scene's run in a folder.
CoarseCase coarse_case(const Scene& scene, const std::string& directory);

/// Runs the coarse run of a scene in the folder `coarse_run` of its results, goes on with one that was stopped,
/// or reads one that is complete; none where it does not come to its end.
std::optional<ErrorBars> estimate_errors(const Scene& scene, const Quantities& run, const std::string& directory,
                                         const StopRequest& stop);

}  // namespace parison::forming
