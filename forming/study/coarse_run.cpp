// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/coarse_run.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "core/io/written_files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/folder_run.hpp"
#include "forming/scene/accuracy.hpp"

namespace parison::forming {
namespace {

std::string summary_path(const CoarseCase& coarse) {
  return coarse.directory + "/summary.json";
}

}  // namespace

std::array<double, 2> coarse_run_factors(const Scene& scene) {
  return scene.solid ? std::array{1.5, 2.0} : coarser_factors;
}

std::array<double, 2> partner_run_factors(const Scene& scene) {
  return scene.solid ? coarse_run_factors(scene) : partner_factors;
}

std::vector<CoarseCase> coarse_cases(const Scene& scene, const std::string& directory) {
  std::vector<CoarseCase> cases;
  for (std::size_t i = 0; i < coarse_folders.size(); ++i)
    if (auto coarse = coarse_case(scene, directory + '/' + coarse_folders[i], coarse_run_factors(scene)[i]))
      cases.push_back(std::move(*coarse));
  return cases;
}

std::optional<CoarseCase> coarse_case(const Scene& scene, const std::string& directory, double factor) {
  if (factor * scene.accuracy_choice.coarsening_factor > max_coarsening) return std::nullopt;
  return CoarseCase{scene.file, coarsened_text(scene.accuracy_name, factor), directory, scene.overrides, factor};
}

bool has_ended(const CoarseCase& coarse) {
  const auto summary = core::read_json_file(summary_path(coarse));
  return summary && !summary->flag_of("stopped");
}

bool finish(const CoarseCase& coarse, const Observers& observers, const StopRequest& stop, const RunFiles& files) {
  const std::string& folder = coarse.directory;
  const Scene scene = read_scene(coarse.file, coarse.accuracy, coarse.overrides);
  const bool is_begun = has_checkpoint(folder);
  if (!is_begun) core::remove_own(folder);  // what was killed before its first checkpoint
  const RunOutcome outcome = is_begun ? resume_in_folder(scene, folder, observers, stop, remesh::triangulate, files)
                                      : run_in_folder(scene, folder, observers, stop, remesh::triangulate, files);
  write_summary(folder, scene, outcome);
  return !outcome.facts.stopped && !outcome.facts.interrupted;
}

std::vector<std::string> failed_coarse_runs(const std::vector<CoarseCase>& coarse) {
  std::vector<std::string> failed;
  for (const CoarseCase& one : coarse) {
    const auto summary = core::read_json_file(summary_path(one));
    if (!summary || !summary->flag_of("completed"))
      failed.push_back(fmt::format("the run {:g} times coarser stopped in {} ({})", one.factor,
                                   summary ? summary->text_of("reason") : "no summary", summary_path(one)));
  }
  return failed;
}

ErrorBars estimate_errors(const Quantities& run, const std::vector<CoarseCase>& coarse) {
  std::vector<CoarserRun> completed;
  for (const CoarseCase& one : coarse) {
    const auto summary = core::read_json_file(summary_path(one));
    if (summary && summary->flag_of("completed"))
      completed.push_back({one.factor, read_quantities(*summary), summary->number_of("cpu_seconds")});
  }
  return error_bars(run, std::move(completed));
}

}  // namespace parison::forming
