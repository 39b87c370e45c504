// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/coarse_run.hpp"

#include <filesystem>

#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene/accuracy.hpp"
#include "forming/scene/calibration.hpp"

namespace parison::forming {
namespace {

std::string summary_path(const CoarseCase& coarse) {
  return coarse.directory + "/summary.json";
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

bool has_completed(const CoarseCase& coarse) {
  const std::string path = summary_path(coarse);
  return std::filesystem::exists(path) && core::read_json(core::read_text(path), path).flag_of("completed");
}

bool complete(const CoarseCase& coarse, const Observers& observers, const StopRequest& stop) {
  const std::string& folder = coarse.directory;
  const Scene scene = read_scene(coarse.file, coarse.accuracy, coarse.overrides);
  if (!has_checkpoint(folder)) std::filesystem::remove_all(folder);  // what was killed before its first checkpoint
  const RunOutcome outcome = has_checkpoint(folder) ? resume_in_folder(scene, folder, observers, stop)
                                                    : run_in_folder(scene, folder, observers, stop);
  write_summary(folder, scene, outcome.state, outcome.facts);
  return outcome.facts.completed;
}

ErrorBars estimate_errors(const Scene& scene, const Quantities& run, const CoarseCase& coarse) {
  const std::string path = summary_path(coarse);
  const core::JsonValue summary = core::read_json(core::read_text(path), path);
  ErrorBars bars = error_bars(run, read_quantities(summary), expected_errors(scene));
  bars.coarse_run_cpu_seconds = summary.number_of("cpu_seconds");
  return bars;
}

}  // namespace parison::forming
