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

/// Edges and steps of these runs over those of a scene's run. In space they are 1.5 and 2 times as long: three times as
/// long leave a corner of a mould one or two cells, and such a run told a bar twice as wide as these two do.
std::array<double, 2> coarse_run_factors(const Scene& scene);

/// The coarser runs by which a what-if compares two runs, in folders of each. The nearer one is twice as coarse instead
/// of the 1.5 times of a single run's error bars: that costs less, and its scatter counts 1.6 times in Richardson's
/// estimate, not three times. In space it is that of the error bars.
inline constexpr std::array partner_folders{"partner_run", coarse_folders.back()};
inline constexpr std::array partner_factors{2.0, coarser_factors.back()};
std::array<double, 2> partner_run_factors(const Scene& scene);

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

/// A sentence for each that failed on its way, with its reason.
std::vector<std::string> failed_coarse_runs(const std::vector<CoarseCase>& coarse);

/// Error bars of the quantities of a run by those of its coarser runs that came to their end.
ErrorBars estimate_errors(const Quantities& run, const std::vector<CoarseCase>& coarse);

}  // namespace parison::forming
