// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/coarse_run.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/calibration.hpp"

namespace parison::forming {
namespace {

/// The same case in the same state of the program, run to its end.
bool is_complete(const std::string& directory) {
  const std::string path = directory + "/summary.json";
  return std::filesystem::exists(path) && core::read_json(core::read_text(path), path).flag_of("completed");
}

/// What the error law of the presets expects, of scenes that it is of; the meshes and steps of others are often their
/// own.
ExpectedErrors expected_errors(const Scene& scene) {
  if (!scene.is_of_error_law()) return {};
  const double level = scene.accuracy_choice.effective_level();
  return {calibration().error_law.thickness.at(level), calibration().error_law.heat.at(level)};
}

}  // namespace

CoarseCase coarse_case(const Scene& scene, const std::string& directory) {
  return {scene.file, coarsened_text(scene.accuracy_name, coarsening_factor), directory + "/coarse_run",
          scene.overrides};
}

std::optional<ErrorBars> estimate_errors(const Scene& scene, const Quantities& run, const std::string& directory,
                                         const StopRequest& stop) {
  const CoarseCase coarse_run = coarse_case(scene, directory);
  const std::string &folder = coarse_run.directory, path = folder + "/summary.json";
  if (!is_complete(folder)) {
    const Scene coarse = read_scene(coarse_run.file, coarse_run.accuracy, coarse_run.overrides);
    fmt::print("\nthe coarse run for the error bars, in {}\n", folder);
    if (!has_checkpoint(folder)) std::filesystem::remove_all(folder);  // what was killed before its first checkpoint
    const RunOutcome outcome =
        has_checkpoint(folder) ? resume(coarse, folder, stop) : forming::run(coarse, folder, stop);
    write_summary(folder, coarse, outcome.state, outcome.facts);
    if (!outcome.facts.completed) return {};
  }
  const core::JsonValue summary = core::read_json(core::read_text(path), path);
  ErrorBars bars = error_bars(run, read_quantities(summary), expected_errors(scene));
  bars.coarse_run_cpu_seconds = summary.number_of("cpu_seconds");
  return bars;
}

}  // namespace parison::forming
