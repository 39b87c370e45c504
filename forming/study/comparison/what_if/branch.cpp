// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/io/manifest.hpp"
#include "core/io/written_files.hpp"
#include "core/process/run_error.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/study/coarse_run.hpp"
#include "forming/study/comparison/finished_run.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

/// Whether a file or folder of a run is none of another run in its folder and no result of its end.
bool is_taken_over(const std::string& name, const std::string& stage) {
  if (is_run_folder(name) || name == "summary.json") return false;
  const bool is_checkpoint = name.rfind("checkpoint", 0) == 0;
  return !is_checkpoint || name == fmt::format("checkpoint_after_{}.h5", stage);
}

/// Writes the checkpoint again with the tools warmer. The case that the run was made of may be gone, or start from
/// results that are: the one given is as it was.
void warm_tools(const std::string& directory, const std::string& case_path) {
  const CaseOrigin origin = read_origin(find_checkpoint(directory));
  const Scene scene = read_scene(case_path, origin.accuracy, origin.overrides);
  Checkpoint checkpoint = read_checkpoint(find_checkpoint(directory), scene);
  for (ToolState& tool : checkpoint.outcome.state.tools) tool.temperature.array() += twin_warmer;
  write_checkpoint(directory, scene, checkpoint);
}

}  // namespace

bool is_run_folder(const std::string& name) {
  const auto begins_with = [&](const char* word) { return name.rfind(word, 0) == 0; };
  const bool is_unfinished = begins_with(core::reserved_prefix) && name != core::manifest_name;
  return is_unfinished || begins_with(twin_folder) ||
         std::any_of(coarse_folders.begin(), coarse_folders.end(), begins_with) ||
         std::any_of(partner_folders.begin(), partner_folders.end(), begins_with);
}

void make_branch(const PlannedRun& run, const std::string& case_path) {
  const BranchPoint& from = *run.branch;
  const std::string made = core::unfinished_name(run.directory);
  core::remove_own(run.directory);
  core::remove_own(made);
  std::error_code error;
  fs::create_directories(made, error);
  for (const auto& entry : fs::directory_iterator(from.directory)) {
    if (error) break;
    if (is_taken_over(entry.path().filename().string(), from.stage))
      fs::copy(entry.path(), fs::path(made) / entry.path().filename(), fs::copy_options::recursive, error);
  }
  if (!error) {
    return_to_stage_end(made, from.stage);
    if (from.warmer_tools) warm_tools(made, case_path);
    fs::rename(made, run.directory, error);
  }
  if (error)
    throw core::SystemError(fmt::format("{}: cannot be made: {}", run.directory, error.message()), error.value());
}

}  // namespace parison::forming
