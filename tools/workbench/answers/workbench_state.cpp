// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/answers/workbench_state.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <regex>

#include "core/io/files.hpp"
#include "tools/program/child_process.hpp"
#include "tools/workbench/folder/left_files.hpp"
#include "tools/workbench/folder/recent_folders.hpp"

namespace parison::tools {

OpenCase& WorkbenchState::open(const std::string& name) {
  const std::string file = folder.case_file(name);
  auto& one = cases_[file];
  if (one)
    one->look();
  else
    one = std::make_unique<OpenCase>(file);
  return *one;
}

WatchedFolder& WorkbenchState::watched(const std::string& results) {
  const std::string path = folder.existing(results);
  auto& one = shown_[path];
  if (!one) one = std::make_unique<WatchedFolder>(path);
  return *one;
}

std::string WorkbenchState::address_of(const std::string& recent) {
  const auto known = recent_folders();
  if (std::find(known.begin(), known.end(), recent) == known.end())
    throw core::CaseError(fmt::format("{}: is none of the folders that were opened before", recent));
  auto& [child, log] = neighbours_[recent];
  if (log.empty() || has_ended(child)) {
    log = (std::filesystem::path(passing_folder()) / "log").string();
    child = start_self({"workbench", recent, "--no-browser"}, log);
  }
  constexpr int looks = 250;  // five seconds
  static const std::regex address("http://127\\.0\\.0\\.1:[0-9]+/[0-9a-f]+/");
  std::smatch found;
  for (int i = 0; i < looks; ++i) {
    if (const std::string text = core::read_text(log); std::regex_search(text, found, address)) return found[0];
    usleep(poll_microseconds);
  }
  throw core::CaseError(fmt::format("{}: its workbench has not started: {}", recent, core::read_text(log)));
}

}  // namespace parison::tools
