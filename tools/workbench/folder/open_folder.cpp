// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/folder/open_folder.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/case/case_error.hpp"
#include "tools/program/bundled_cases.hpp"
#include "tools/report/data/result_folder.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

const std::string bundled = "bundled:";

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw core::CaseError(fmt::format("\"{}\": {}", name, why));
}

bool is_inside(const fs::path& path, const fs::path& folder) {
  const fs::path below = path.lexically_relative(folder);
  return !below.empty() && *below.begin() != "..";
}

/// Names by the time of a file of each, newest first.
std::vector<std::string> by_time(std::vector<std::pair<fs::file_time_type, std::string>> found) {
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a > b; });
  std::vector<std::string> names;
  for (auto& one : found) names.push_back(std::move(one.second));
  return names;
}

}  // namespace

bool is_bundled(const std::string& name) {
  return name.compare(0, bundled.size(), bundled) == 0;
}

OpenFolder::OpenFolder(const std::string& path) {
  std::error_code error;
  path_ = fs::canonical(path, error).string();
  if (error || !fs::is_directory(path_))
    throw core::CaseError(fmt::format("{}: is no folder, allowed is the folder to work in", path));
}

FolderContent OpenFolder::content() const {
  constexpr int deepest = 4, most_seen = 20'000;
  std::vector<std::pair<fs::file_time_type, std::string>> cases, results;
  std::error_code error;
  const auto options = fs::directory_options::skip_permission_denied;
  int seen = 0;
  for (fs::recursive_directory_iterator at(path_, options, error), end; at != end && seen++ < most_seen;
       at.increment(error)) {
    const fs::path& path = at->path();
    const std::string name = path.filename().string(), below = path.lexically_relative(path_).string();
    std::error_code gone;
    if (at->is_symlink(gone)) continue;
    if (at->is_directory(gone)) {
      const bool is_result = is_result_folder(path.string()) || fs::exists(path / "comparison.json", gone) ||
                             fs::exists(path / "result.json", gone);
      if (is_result) results.emplace_back(fs::last_write_time(path, gone), below);
      if (is_result || name.front() == '.' || at.depth() + 1 >= deepest) at.disable_recursion_pending();
    } else if (name == "case.toml") {
      cases.emplace_back(fs::last_write_time(path, gone), below);
    }
  }
  return {by_time(std::move(cases)), by_time(std::move(results))};
}

std::string OpenFolder::existing(const std::string& name) const {
  std::error_code error;
  const fs::path path = fs::canonical(fs::path(path_) / name, error);
  if (name.find('\0') != name.npos || error || !is_inside(path, path_))
    refuse(name, "no such file or folder in the opened one");
  return path.string();
}

std::string OpenFolder::case_file(const std::string& name) const {
  if (is_bundled(name)) {
    const std::string word = name.substr(bundled.size());
    const fs::path file = shared_file("cases") / word / "case.toml";
    if (word.find('/') != word.npos || word.find("..") != word.npos || !fs::exists(file))
      refuse(name, "no such bundled case");
    return file.string();
  }
  const std::string file = existing(name);
  if (fs::path(file).extension() != ".toml" || !fs::is_regular_file(file)) refuse(name, "is no case file");
  return file;
}

std::string OpenFolder::new_folder(const std::string& name) const {
  if (name.empty() || name.front() == '.' || name.find_first_of(std::string("/\\\0", 3)) != name.npos)
    refuse(name, "was found, allowed is the name of a new folder");
  return (fs::path(path_) / name).string();
}

std::string OpenFolder::new_results(const std::string& case_name) const {
  const fs::path results = fs::path(path_) / "results";
  fs::create_directories(results);
  if (!is_inside(fs::canonical(results), path_)) refuse("results", "leads outside the opened folder");
  for (int i = 1;; ++i) {
    const std::string name = i == 1 ? case_name : fmt::format("{}_{}", case_name, i);
    if (!fs::exists(results / name) && !fs::exists(results / (name + ".log"))) return "results/" + name;
  }
}

}  // namespace parison::tools
