// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/runs/runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <thread>

#include "core/case/case_error.hpp"
#include "core/case/text/case_text.hpp"
#include "core/io/files.hpp"
#include "forming/study/comparison/study_folder.hpp"
#include "tools/program/child_process.hpp"
#include "tools/report/data/result_folder.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

/// The end of a text file, from the begin of a line; empty without one.
std::string tail_of(const std::string& path) {
  constexpr std::size_t shown = 3000;
  if (!fs::exists(path)) return "";
  const std::string text = core::read_text(path);
  if (text.size() <= shown) return text;
  return text.substr(std::min(text.size(), text.find('\n', text.size() - shown) + 1));
}

void add_progress(const ResultFolder& folder, core::JsonWriter& json) {
  const auto* times = folder.history.column("time_s");
  if (times && !times->empty()) json.add("time_s", times->back());
  if (!folder.stages.empty()) json.add("stage", folder.stages.back().name);
  json.add("told", folder.told);
}

}  // namespace

bool Runs::is_alive(const std::string& results) {
  const auto found = children_.find(results);
  if (found == children_.end()) return false;
  if (!has_ended(found->second)) return true;
  children_.erase(found);
  return false;
}

void Runs::begin(const std::vector<std::string>& words, const std::string& results) {
  const unsigned most = std::max(1u, std::thread::hardware_concurrency());
  std::vector<std::string> names;
  for (const auto& child : children_) names.push_back(child.first);
  const auto alive = std::count_if(names.begin(), names.end(), [&](const auto& name) { return is_alive(name); });
  if (alive >= static_cast<long>(most))
    throw core::CaseError(fmt::format("{} runs go on already, allowed are as many as there are processors", alive));
  children_[results] = start_self(words, (fs::path(folder_.path()) / (results + ".log")).string());
}

namespace {

const std::string what_if_begin = "what_if_", search_begin = "optimise_";

/// A table of a goal file for bounds, "key=from to to".
std::string variable_text(const std::string& bounds) {
  static const std::regex form(R"(\s*([^=]+?)\s*=\s*(.+?)\s+to\s+(.+?)\s*)");
  std::smatch found;
  if (!std::regex_match(bounds, found, form))
    throw core::CaseError(
        fmt::format("\"{}\" was found, allowed are bounds such as stage.reheat.duration=1 s to 2 s", bounds));
  return fmt::format("[[variable]]\nkey = {}\nfrom = {}\nto = {}\n", core::quoted(found[1]), core::quoted(found[2]),
                     core::quoted(found[3]));
}

/// The goal file of the folder of a search; empty for others.
std::string goal_of(const fs::path& folder) {
  const fs::path goal = folder.string() + ".toml";
  return folder.filename().string().rfind(search_begin, 0) == 0 && fs::exists(goal) ? goal.string() : "";
}

/// The name of a case by its file.
std::string name_of_case(const std::string& file) {
  const fs::path path(file);
  return path.filename() == "case.toml" ? path.parent_path().filename().string() : path.stem().string();
}

}  // namespace

std::vector<std::string> Runs::of_case(const std::string& case_file) const {
  const std::string own = name_of_case(case_file);
  std::vector<std::string> names;
  for (const std::string& results : folder_.content().results) {
    std::string name = fs::path(results).filename().string();
    for (const std::string& begin : {what_if_begin, search_begin})
      if (name.rfind(begin, 0) == 0) name.erase(0, begin.size());
    if (name.rfind(own, 0) == 0 && std::regex_match(name.substr(own.size()), std::regex("(_[0-9]+)?")))
      names.push_back(results);
  }
  return names;
}

std::string Runs::start(const std::string& case_file, const std::string& accuracy) {
  const std::string results = folder_.new_results(name_of_case(case_file));
  const std::string output = (fs::path(folder_.path()) / results).string();
  begin({"run", case_file, "--accuracy", accuracy, "--output", output, "--keep-going"}, results);
  return results;
}

std::string Runs::start_what_if(const std::string& case_file, const std::string& accuracy,
                                const std::vector<std::string>& changes) {
  const std::string results = folder_.new_results(what_if_begin + name_of_case(case_file));
  std::vector<std::string> words{"what-if", case_file,  "--accuracy",
                                 accuracy,  "--output", (fs::path(folder_.path()) / results).string()};
  for (const std::string& change : changes) words.insert(words.end(), {"--set", change});
  begin(words, results);
  return results;
}

std::string Runs::start_search(const std::string& case_file, const std::string& accuracy, const std::string& wall,
                               const std::string& from, const std::vector<std::string>& bounds) {
  if (bounds.empty()) throw core::CaseError("bounds: none were found, allowed is one or more");
  std::string goal = fmt::format("case = {0}\naccuracy = {1}\nconfirm = {1}\n[goal]\nwall = {2}\n",
                                 core::quoted(case_file), core::quoted(accuracy), core::quoted(wall));
  if (!from.empty()) goal += fmt::format("from = {}\n", core::quoted(from));
  for (const std::string& one : bounds) goal += variable_text(one);
  const std::string results = folder_.new_results(search_begin + name_of_case(case_file));
  const std::string output = (fs::path(folder_.path()) / results).string();
  core::replace_file(output + ".toml", goal);
  begin({"optimise", output + ".toml", "--output", output}, results);
  return results;
}

void Runs::add_study(const std::string& results, bool alive, core::JsonWriter& json) {
  const fs::path path = fs::path(folder_.path()) / results;
  bool has_report = fs::exists(path / "report.html");
  if (!alive && !has_report && forming::study_folder(path.string()) && reported_.insert(results).second) {
    begin({"report", path.string()}, results);
    alive = true;
  }
  has_report = has_report && !alive;
  json.add("study", has_report);
  json.add("goes_on", !has_report && fs::exists(path) && !goal_of(path).empty());
  if (const fs::path found = path / "case" / "case.toml"; has_report && fs::exists(found))
    json.add("case", results + "/case/case.toml");
  json.add("state", alive ? "running" : has_report ? "completed" : "failed");
  json.add("log", has_report ? "" : tail_of(path.string() + ".log"));
}

void Runs::resume(const std::string& results) {
  const std::string folder = folder_.existing(results);
  if (is_alive(results) || is_written(folder)) throw core::CaseError(fmt::format("{}: goes on already", results));
  if (const std::string goal = goal_of(folder); !goal.empty())
    begin({"optimise", goal, "--output", folder}, results);
  else
    begin({"resume", folder, "--keep-going"}, results);
}

void Runs::stop(const std::string& results) {
  if (!is_alive(results))
    throw core::CaseError(fmt::format("{}: no run of this workbench was found going on", results));
  request_stop(children_.at(results));
}

void Runs::add_state(const std::string& results, core::JsonWriter& json) {
  const bool alive = is_alive(results);
  const std::string path = (fs::path(folder_.path()) / results).string();
  json.add("results", results);
  json.add("ours", alive);
  if (!is_result_folder(path)) return add_study(results, alive, json);
  const ResultFolder folder = read_folder(folder_.existing(results));
  json.add("state", alive ? "running" : name_of(folder.state));
  add_progress(folder, json);
  json.add("log", alive ? "" : tail_of(path + ".log"));
}

}  // namespace parison::tools
