// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "core/process/run_error.hpp"
#include "forming/study/comparison/study_folder.hpp"
#include "tools/program/bundled_cases.hpp"
#include "tools/report/data/result_folder.hpp"
#include "tools/report/data/run_data.hpp"
#include "tools/report/data/run_names.hpp"

namespace parison::tools {

namespace {

/// In the order in which one needs the other.
constexpr const char* scripts[] = {
    "elements.js",    "colours.js",  "data.js",       "raster.js",       "section.js",   "player.js",
    "film.js",        "charts.js",   "figures.js",    "polariscope.js",  "machine.js",   "space/data.js",
    "space/cut.js",   "space/gl.js", "space/view.js", "space/screen.js", "space/map.js", "space/sections.js",
    "space/space.js", "tables.js",   "search.js",     "production.js",   "main.js"};

std::string page_file(const std::string& name) {
  const auto path = shared_file("tools/report/page/" + name);
  if (path.empty()) throw core::RunError("share/parison/tools/report/page/" + name + " is missing beside the program");
  return core::read_text(path.string());
}

std::string script_text() {
  std::string text;
  for (const char* name : scripts) text += page_file(name);
  return text;
}

}  // namespace

std::string html_text(const std::string& text) {
  const std::map<char, std::string> escapes{
      {'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}};
  std::string escaped;
  for (const char c : text) {
    const auto found = escapes.find(c);
    escaped += found == escapes.end() ? std::string(1, c) : found->second;
  }
  return escaped;
}

std::string page_text(const std::string& title, const std::string& data) {
  const std::map<std::string, std::string> parts{{"title", html_text(title)},
                                                 {"style", page_file("style.css")},
                                                 {"plot_style", page_file("uplot/uPlot.min.css")},
                                                 {"plot_script", page_file("uplot/uPlot.iife.min.js")},
                                                 {"script", script_text()},
                                                 {"data", data}};
  const std::string frame = page_file("page.html"), open = "{{", close = "}}";
  std::string text;
  std::size_t at = 0;
  for (std::size_t next; (next = frame.find(open, at)) != std::string::npos;) {
    const std::size_t end = frame.find(close, next);
    text += frame.substr(at, next - at) + parts.at(frame.substr(next + 2, end - next - 2));
    at = end + close.size();
  }
  return text + frame.substr(at);
}

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
