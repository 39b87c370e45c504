// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/runs/runs.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <thread>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
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

std::string Runs::start(const std::string& case_file, const std::string& accuracy) {
  fs::path name = fs::path(case_file).parent_path().filename();
  if (fs::path(case_file).filename() != "case.toml") name = fs::path(case_file).stem();
  const std::string results = folder_.new_results(name.string());
  const std::string output = (fs::path(folder_.path()) / results).string();
  begin({"run", case_file, "--accuracy", accuracy, "--output", output, "--keep-going"}, results);
  return results;
}

void Runs::resume(const std::string& results) {
  const std::string folder = folder_.existing(results);
  if (is_alive(results) || is_written(folder)) throw core::CaseError(fmt::format("{}: goes on already", results));
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
  if (is_result_folder(path)) {
    const ResultFolder folder = read_folder(folder_.existing(results));
    json.add("state", alive ? "running" : name_of(folder.state));
    add_progress(folder, json);
  } else {
    json.add("state", alive ? "running" : "failed");
  }
  json.add("log", alive ? "" : tail_of(path + ".log"));
}

}  // namespace parison::tools
