// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/what_if/finished_base.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <optional>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/json_read.hpp"
#include "core/io/written_files.hpp"
#include "core/process/build_id.hpp"
#include "core/process/run_error.hpp"
#include "forming/report/files/case_copy.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/study/comparison/comparison.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

std::optional<core::JsonValue> summary_of(const std::string& directory) {
  return core::read_json_file(directory + "/summary.json");
}

bool is_of_this_build(const core::JsonValue& summary) {
  return !core::build_id().empty() && summary.text_of("program_build") == core::build_id();
}

/// Whether the case at a path is the one that a run was made of.
bool is_as_it_was(const FinishedBase& base, const std::string& fingerprint) {
  std::error_code unreadable;
  if (!fs::exists(base.case_path, unreadable)) return false;
  try {
    return core::fingerprint_text(read_scene(base.case_path, base.accuracy, base.overrides).fingerprint) == fingerprint;
  } catch (const core::CaseError&) {  // a file that it names is no longer there
    return false;
  }
}

}  // namespace

bool is_result_folder(const std::string& path) {
  std::error_code unreadable;
  return fs::is_regular_file(path + "/summary.json", unreadable);
}

bool has_completed_here(const std::string& directory) {
  const auto summary = summary_of(directory);
  return summary && summary->flag_of("completed") && is_of_this_build(*summary);
}

FinishedBase read_finished_base(const std::string& directory) {
  const core::JsonValue summary = summary_of(directory).value_or(core::JsonValue{});
  if (!summary.flag_of("completed")) throw core::CaseError(no_base(directory, summary.text_of("reason")));
  if (!is_of_this_build(summary))
    throw core::CaseError(
        fmt::format("{}: a run by another build of the program was found, which may differ from this one in its "
                    "numbers; allowed as the base is one by this program, or the case itself, which is then run",
                    directory));
  FinishedBase base{"", summary.text_of("accuracy"), {}};
  if (const core::JsonValue* overrides = summary.find("overrides"))
    for (const core::JsonValue& assignment : overrides->items) base.overrides.push_back(assignment.text);
  for (const std::string& known : {case_copy_folder(directory), read_origin(find_checkpoint(directory)).file}) {
    base.case_path = known;
    if (is_as_it_was(base, summary.text_of("case_fingerprint"))) return base;
  }
  throw core::CaseError(fmt::format(
      "{}: neither the copy of the case in it nor the case that it was made of is any longer as the run had "
      "it; allowed as the base is a run whose case is as it was",
      directory));
}

void copy_results(const PlannedRun& run) {
  const std::string made = core::unfinished_name(run.directory);
  std::error_code error;
  core::remove_own(made);
  fs::create_directories(made, error);
  for (const auto& entry : fs::directory_iterator(run.copy_of, error)) {
    if (is_run_folder(entry.path().filename().string())) continue;
    fs::copy(entry.path(), fs::path(made) / entry.path().filename(), fs::copy_options::recursive, error);
    if (error) break;
  }
  if (!error) core::remove_own(run.directory);
  if (!error) fs::rename(made, run.directory, error);
  if (error)
    throw core::SystemError(fmt::format("{}: cannot be copied to {}: {}", run.copy_of, run.directory, error.message()),
                            error.value());
}

}  // namespace parison::forming
