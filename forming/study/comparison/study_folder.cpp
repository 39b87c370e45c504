// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/study_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "core/case/number.hpp"
#include "core/io/json_read.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::forming {

std::optional<CycleResult> read_cycle_result(const std::string& folder) {
  const auto found = core::read_json_file(folder + "/cycle.json");
  if (!found) return std::nullopt;
  const core::JsonValue& json = *found;
  CycleResult result{json.text_of("reason"), {}, {}};
  if (const core::JsonValue* changes = json.find("changes"))
    for (const core::JsonValue& change : changes->items)
      result.changes.push_back({change.text_of("key"), change.text_of("base"), change.text_of("other")});
  if (const core::JsonValue* sentences = json.find("not_possible"))
    for (const core::JsonValue& one : sentences->items)
      result.not_possible += (result.not_possible.empty() ? "" : "; ") + one.text;
  return result;
}

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

/// The folders of the accuracies that --resolve has made, the finest first.
std::vector<std::string> rounds_in(const std::string& folder) {
  const std::string prefix = "at_draft_coarser_";
  std::vector<std::pair<double, std::string>> found;
  for (const std::string& name : folders_in(folder))
    if (name.rfind(prefix, 0) == 0)
      if (const auto factor = core::leading_number(std::string_view(name).substr(prefix.size())))
        found.emplace_back(factor->value, folder + '/' + name);
  std::sort(found.begin(), found.end());
  std::vector<std::string> rounds;
  for (auto& [factor, round] : found) rounds.push_back(std::move(round));
  return rounds;
}

/// The runs of the finest round that has a table, which is written at its end; of the finest where none has.
StudyFolder resolved_study(const std::string& folder) {
  const std::vector<std::string> rounds = rounds_in(folder);
  if (rounds.empty()) return {};
  const auto has_table = [](const std::string& round) {
    std::error_code unreadable;
    return fs::exists(round + "/comparison.json", unreadable);
  };
  auto chosen = std::find_if(rounds.begin(), rounds.end(), has_table);
  if (chosen == rounds.end()) chosen = rounds.begin();
  auto runs = base_and_others(*chosen, "");
  if (runs.empty()) return {};
  return {StudyFolder::Kind::what_if, std::move(runs), {}, chosen == rounds.begin() ? "" : rounds.front()};
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
  return resolved_study(folder);
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
