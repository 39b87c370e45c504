#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
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

/// Whether it has run to its end.
bool has_completed(const CoarseCase& coarse);

/// Runs it, or continues it where it was stopped; whether it came to its end.
bool complete(const CoarseCase& coarse, const Observers& observers, const StopRequest& stop);

/// Error bars of the quantities of a run by its coarse run, which has completed.
ErrorBars estimate_errors(const Scene& scene, const Quantities& run, const CoarseCase& coarse);

}  // namespace parison::forming
