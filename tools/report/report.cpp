// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "forming/study/comparison/study_folder.hpp"
#include "tools/report/data/result_folder.hpp"
#include "tools/report/data/run_data.hpp"
#include "tools/report/data/run_names.hpp"
#include "tools/report/page.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

/// More could not be told apart in one plot.
constexpr std::size_t most_folders = 6;
constexpr double megabyte = 1e6;

void check(const ReportRequest& request) {
  if (request.folders.size() > most_folders)
    throw core::CaseError(fmt::format("report: {} folders were found, allowed are up to {} on one page; found were {}",
                                      request.folders.size(), most_folders, fmt::join(request.folders, ", ")));
  for (auto folder = request.folders.begin(); folder != request.folders.end(); ++folder)
    if (std::find(request.folders.begin(), folder, *folder) != folder)
      throw core::CaseError(fmt::format("report: {} was given twice", *folder));
  const std::string ending = fs::path(request.output).extension().string();
  if (!request.output.empty() && ending != ".html" && ending != ".htm")
    throw core::CaseError(fmt::format("--output: \"{}\" was found, allowed is a file named .html", request.output));
}

/// The folders of runs: those given, and the runs of a folder of a what-if or a cycle in its place, with its variants
/// that did not settle.
struct ReportedRuns {
  std::vector<std::string> folders = {};
  std::vector<forming::FailedVariant> failed = {};
};

ReportedRuns reported_runs(const std::vector<std::string>& given) {
  auto runs = ReportedRuns();
  auto& [folders, failed] = runs;
  for (const std::string& folder : given) {
    const auto study = forming::study_folder(folder);
    failed.insert(failed.end(), study.failed.begin(), study.failed.end());
    if (study)
      folders.insert(folders.end(), study.runs.begin(), study.runs.end());
    else
      folders.push_back(folder);
  }
  return runs;
}

}  // namespace

int report(const ReportRequest& given) {
  ReportRequest request = given;
  const ReportedRuns runs = reported_runs(given.folders);
  request.folders = runs.folders;
  check(request);
  for (const std::string& path : request.folders)
    if (const ResultFolder folder = read_folder(path); !folder.told.empty()) fmt::print("{}: {}\n", path, folder.told);
  const std::string output =
      request.output.empty() ? (fs::path(given.folders[0]) / "report.html").string() : request.output;
  core::require_own(output);
  ReportCache cache;
  const std::string title = fmt::format("{}", fmt::join(run_names(request.folders), ", "));
  if (const std::string mixed = mixed_cases(request.folders, cache); !mixed.empty())
    fmt::print(stderr, "parison: {}\n", mixed);
  const std::string page = page_text(title, report_data(request.folders, false, cache, request.search, runs.failed));
  core::replace_file(output, page);
  fmt::print("{}: {:.1f} MB, open it in a browser\n", output, static_cast<double>(page.size()) / megabyte);
  return 0;
}

}  // namespace parison::tools
