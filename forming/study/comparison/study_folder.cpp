// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/study_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>

#include "forming/study/comparison/cycle_result.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

constexpr const char* first_gob = "first_gob";
constexpr const char* settled = "settled";

bool has_run(const std::string& folder) {
  std::error_code unreadable;
  return fs::is_regular_file(folder + "/history.csv", unreadable);
}

std::vector<std::string> folders_in(const std::string& folder) {
  std::vector<std::string> found;
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable))
    if (entry.is_directory(unreadable)) found.push_back(entry.path().filename().string());
  std::sort(found.begin(), found.end());
  return found;
}

/// The base and all others below a folder, each in a folder of that name below its own; empty without a base.
std::vector<std::string> base_and_others(const std::string& folder, const std::string& below) {
  const auto run_of = [&](const std::string& name) { return folder + '/' + name + below; };
  if (!has_run(run_of(base_name))) return {};
  std::vector<std::string> runs{run_of(base_name)};
  for (const std::string& name : folders_in(folder))
    if (name != base_name && has_run(run_of(name))) runs.push_back(run_of(name));
  return runs;
}

/// Takes the variants of a cycle that did not settle out of the runs.
StudyFolder with_failed(StudyFolder study, const std::string& folder) {
  for (const std::string& name : folders_in(folder)) {
    const auto result = name == base_name ? std::nullopt : read_cycle_result(folder + '/' + name);
    if (!result || result->reason.empty()) continue;
    study.failed.push_back({name, result->changes, result->reason});
    const auto run = std::find(study.runs.begin(), study.runs.end(), folder + '/' + name + '/' + settled);
    if (run != study.runs.end()) study.runs.erase(run);
  }
  return study;
}

/// The folder of the finest accuracy among those that --resolve has made; nothing without one.
std::optional<std::string> finest_round(const std::string& folder) {
  const std::string prefix = "at_draft_coarser_";
  std::optional<std::string> finest;
  double least = 0;
  for (const std::string& name : folders_in(folder)) {
    if (name.rfind(prefix, 0) != 0) continue;
    const double factor = std::strtod(name.c_str() + prefix.size(), nullptr);
    if (factor > 0 && (!finest || factor < least)) finest = folder + '/' + name, least = factor;
  }
  return finest;
}

}  // namespace

StudyFolder study_folder(const std::string& given) {
  std::string folder = given;
  while (folder.size() > 1 && folder.back() == '/') folder.pop_back();
  if (has_run(folder)) return {};
  if (auto runs = base_and_others(folder, ""); !runs.empty()) return {StudyFolder::Kind::what_if, std::move(runs)};
  if (auto runs = base_and_others(folder, std::string("/") + settled); !runs.empty())
    return with_failed({StudyFolder::Kind::cycle, std::move(runs)}, folder);
  if (has_run(folder + '/' + first_gob)) {
    StudyFolder study{StudyFolder::Kind::cycle, {folder + '/' + first_gob}};
    for (const char* name : {settled, "just_swabbed"})
      if (has_run(folder + '/' + name)) study.runs.push_back(folder + '/' + name);
    return study;
  }
  const auto round = finest_round(folder);
  auto runs = round ? base_and_others(*round, "") : std::vector<std::string>{};
  return runs.empty() ? StudyFolder{} : StudyFolder{StudyFolder::Kind::what_if, std::move(runs)};
}

std::string study_text(const StudyFolder& study) {
  return study.kind == StudyFolder::Kind::cycle ? "is the folder of a cycle" : "is the folder of a what-if";
}

std::string results_as_case(const std::string& folder) {
  std::error_code unreadable;
  if (!fs::is_directory(folder, unreadable) || fs::exists(folder + "/case.toml", unreadable)) return {};
  if (has_run(folder))
    return fmt::format(
        "{0}: it is the result folder of a run, allowed is a case, such as the copy of its own in {0}/case, without "
        "what "
        "--set has changed",
        folder);
  const StudyFolder study = study_folder(folder);
  if (!study) return {};
  const bool is_first_gob = fs::path(study.runs.front()).filename() == first_gob && study.runs.size() > 1;
  const std::string& run = study.runs[is_first_gob ? 1 : 0];
  return fmt::format(
      "{}: it {}, allowed is a case, such as {}/case; `parison what-if` also takes a run as the base, such as {}",
      folder, study_text(study), run, run);
}

}  // namespace parison::forming
