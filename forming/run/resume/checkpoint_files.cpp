// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/resume/checkpoint_files.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <vector>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/hdf5.hpp"
#include "core/io/written_files.hpp"
#include "core/process/run_error.hpp"

namespace parison::forming {
namespace {

std::string last_path(const std::string& directory) {
  return directory + "/checkpoint.h5";
}
std::string path_before(const std::string& directory) {
  return directory + "/checkpoint_before.h5";
}

constexpr const char* kept_prefix = "checkpoint_after_";
std::string path_after(const std::string& directory, const std::string& stage) {
  return directory + '/' + kept_prefix + stage + ".h5";
}

bool is_of_stage_end(const std::filesystem::path& path) {
  return path.extension() == ".h5" && path.stem().string().rfind(kept_prefix, 0) == 0;
}

bool is_there(const std::string& path) {
  std::error_code unreadable;
  return std::filesystem::exists(path, unreadable);
}

bool is_intact(const std::string& path) {
  return is_there(path) && core::read_hdf5(path).problem.empty();
}

}  // namespace

std::string new_checkpoint(const std::string& directory) {
  return directory + "/checkpoint_new.h5";
}

void put_in_place(const std::string& directory) {
  const std::string last = last_path(directory);
  if (is_intact(last) && core::is_own(last))  // a damaged one, or the user's, never takes the place of a good one
    core::rename_own(last, path_before(directory));
  core::rename_own(new_checkpoint(directory), last);
  core::sync_to_disk(directory);
}

void keep_checkpoint(const std::string& directory, const std::string& stage) {
  core::link_own(last_path(directory), path_after(directory, stage));
}

std::string find_stage_end(const std::string& directory, const std::string& stage) {
  std::string path = path_after(directory, stage);
  if (is_intact(path)) return path;
  std::string names;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(directory, unreadable))
    if (is_of_stage_end(entry.path()))
      names += (names.empty() ? "" : ", ") + entry.path().stem().string().substr(std::string(kept_prefix).size());
  throw core::CaseError(fmt::format("{}: no checkpoint of the end of a stage \"{}\" was found, allowed are {}",
                                    directory, stage, names.empty() ? "none: no stage has ended" : names));
}

void require_own_checkpoints(const std::string& directory) {
  std::vector<std::string> paths{last_path(directory), path_before(directory), new_checkpoint(directory)};
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(directory, unreadable))
    if (is_of_stage_end(entry.path())) paths.push_back(entry.path().string());
  for (const std::string& path : paths)
    if (!core::is_damaged(path)) core::require_own(path);
}

void return_to_stage_end(const std::string& directory, const std::string& stage) {
  const std::string kept = find_stage_end(directory, stage);
  const std::int64_t done = core::open_hdf5(kept).read_integer("stages_done");
  std::vector<std::filesystem::path> later;
  for (const auto& entry : std::filesystem::directory_iterator(directory))
    if (is_of_stage_end(entry.path()) && is_intact(entry.path().string()) &&
        core::open_hdf5(entry.path().string()).read_integer("stages_done") > done)
      later.push_back(entry.path());
  if (is_there(last_path(directory)) && !is_intact(last_path(directory))) core::set_aside(last_path(directory));
  core::replace_file(last_path(directory), core::read_text(kept));
  later.emplace_back(path_before(directory));
  for (const auto& path : later) core::remove_own(path.string());
}

bool has_checkpoint(const std::string& directory) {
  return is_intact(last_path(directory)) || is_intact(path_before(directory));
}

std::string find_checkpoint(const std::string& directory) {
  std::string problems;
  for (const std::string& path : {last_path(directory), path_before(directory)}) {
    if (!is_there(path)) continue;
    const std::string problem = core::read_hdf5(path).problem;
    if (problem.empty()) return path;
    problems += fmt::format("{} {}; ", path, problem);
  }
  if (!problems.empty()) throw core::CaseError(problems + "no other checkpoint is left, the run must begin anew");
  throw core::CaseError(
      fmt::format("{}: no checkpoint was found, allowed is the result folder of a run that has begun", directory));
}

std::string damage_of_last_checkpoint(const std::string& directory) {
  const std::string path = last_path(directory);
  const std::string problem = is_there(path) ? core::read_hdf5(path).problem : "";
  return problem.empty() ? "" : fmt::format("{} {}", path, problem);
}

}  // namespace parison::forming
