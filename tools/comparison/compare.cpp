// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/comparison/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/written_files.hpp"
#include "forming/study/comparison/comparison.hpp"
#include "forming/study/comparison/study_folder.hpp"
#include "forming/study/comparison/what_if/finished_base.hpp"
#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

/// The runs of a what-if or a cycle that have ended; the others are told.
std::vector<std::string> ended_runs(const forming::StudyFolder& study) {
  std::vector<std::string> ended;
  if (!study.unfinished.empty())
    fmt::print("{}: a round that has not ended, it is left out; the last one that has is shown\n", study.unfinished);
  for (const std::string& folder : study.runs)
    if (forming::is_result_folder(folder))
      ended.push_back(folder);
    else
      fmt::print("{}: a run that has not ended, it is left out\n", folder);
  return ended;
}

/// What is compared: the folders given, or of the folder of a what-if or a cycle what its table has.
struct Compared {
  std::vector<std::string> folders;                 ///< the base first
  std::vector<forming::FailedVariant> failed = {};  ///< rows without a folder to compare
};

Compared compared_of(const CompareRequest& request) {
  std::vector<std::string> folders{request.base};
  folders.insert(folders.end(), request.others.begin(), request.others.end());
  if (request.others.empty())
    if (const auto study = forming::study_folder(request.base); study.runs.size() + study.failed.size() > 1)
      if (auto ended = ended_runs(study);
          ended.size() + study.failed.size() > 1 && !ended.empty() && ended.front() == study.runs.front())
        return {std::move(ended), study.failed};
  for (const std::string& folder : folders)
    if (const auto study = forming::study_folder(folder))
      throw core::CaseError(fmt::format("{}: it {}, allowed are result folders, such as {}, or such a folder alone",
                                        folder, forming::study_text(study), fmt::join(study.runs, " and ")));
  if (request.others.empty())
    throw core::CaseError(
        fmt::format("compare: {} alone was found, allowed are at least two result folders, the first one the base, or "
                    "the folder of a what-if or a cycle",
                    request.base));
  return {folders};
}

/// The folder of the what-if or cycle whose table has a run; one or two levels up.
forming::StudyFolder study_of(const std::string& run) {
  fs::path folder = fs::absolute(run).lexically_normal();
  if (!folder.has_filename()) folder = folder.parent_path();
  for (int level = 0; level < 2; ++level) {
    folder = folder.parent_path();
    if (auto study = forming::study_folder(fs::proximate(folder).string())) return study;
  }
  return {};
}

/// Where variants of a what-if are compared with each other, that both are known better against its base, which has
/// twins; else empty.
std::string better_base(const std::vector<std::string>& folders) {
  const forming::StudyFolder study = study_of(folders.front());
  const auto is_variant = [&](const std::string& folder) {
    return std::any_of(study.runs.begin() + 1, study.runs.end(), [&](const std::string& run) {
      std::error_code unreadable;
      return fs::equivalent(run, folder, unreadable);
    });
  };
  if (study.runs.size() < 3 || !std::all_of(folders.begin(), folders.end(), is_variant)) return {};
  return fmt::format(
      "\n  these are variants of one base: against it their differences are known better, `parison compare {} {}`\n",
      study.runs.front(), fmt::join(folders, " "));
}

}  // namespace

int compare(const CompareRequest& request) {
  const auto [folders, failed] = compared_of(request);
  forming::Comparison comparison = forming::compare_folders(folders.front(), {folders.begin() + 1, folders.end()});
  for (const forming::FailedVariant& one : failed)
    comparison.others.push_back({one.name, one.settings, one.reason, {}});
  if (!request.quantity.empty()) forming::require_quantity(request.quantity, comparison.base.quantities.values);
  if (!request.output.empty()) core::claim_folder(request.output, "compare", forming::comparison_files());
  const std::string quantity = request.quantity.empty() ? forming::ranked_quantity(comparison) : request.quantity;
  fmt::print("{}{}", forming::comparison_tables(comparison), forming::ranking_table(comparison, quantity));
  fmt::print("{}", better_base(folders));
  if (!request.output.empty()) fmt::print("\n  {}\n", forming::write_comparison(comparison, request.output));
  return 0;
}

}  // namespace parison::tools
