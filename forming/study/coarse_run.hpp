#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "forming/report/error_bars.hpp"
#include "forming/report/files/result_files.hpp"
#include "forming/run/run.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// The coarser runs of a run, in folders of its own folder.
inline constexpr std::array coarse_folders{"coarse_run", "coarser_run"};
static_assert(coarse_folders.size() == coarser_factors.size());

/// What a coarser run is run with, and where.
struct CoarseCase {
  std::string file, accuracy, directory;
  std::vector<std::string> overrides;
  double factor;
};

/// The coarser runs of a scene's run in a folder, the one nearest to it first.
std::vector<CoarseCase> coarse_cases(const Scene& scene, const std::string& directory);
/// One with edges and steps `factor` times as long, in a folder of its own; none where that would be too coarse.
std::optional<CoarseCase> coarse_case(const Scene& scene, const std::string& directory, double factor);

/// Whether it has come to its end or has failed on its way there, so that there is nothing left to run.
bool has_ended(const CoarseCase& coarse);

/// Runs it, or continues it where it was stopped; whether it has ended then.
bool finish(const CoarseCase& coarse, const Observers& observers, const StopRequest& stop, const RunFiles& files = {});

/// Error bars of the quantities of a run by those of its coarser runs that came to their end.
ErrorBars estimate_errors(const Quantities& run, const std::vector<CoarseCase>& coarse);

}  // namespace parison::forming
