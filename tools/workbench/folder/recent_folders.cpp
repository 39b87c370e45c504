// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/folder/recent_folders.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "core/io/files.hpp"
#include "tools/workbench/edit/open_case.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

/// The file that keeps them; empty where the user has no folder for it.
fs::path kept_file() {
  const char *state = std::getenv("XDG_STATE_HOME"), *home = std::getenv("HOME");
  const bool has_state = state && fs::path(state).is_absolute();
  if (!has_state && !(home && fs::path(home).is_absolute())) return {};
  return (has_state ? fs::path(state) : fs::path(home) / ".local/state") / "parison/workbench_folders";
}

}  // namespace

std::vector<std::string> recent_folders() {
  const fs::path file = kept_file();
  std::error_code error;
  std::vector<std::string> folders;
  if (file.empty() || !fs::is_regular_file(file, error)) return folders;
  std::istringstream lines(core::read_text(file.string()));
  for (std::string line; std::getline(lines, line);)
    if (fs::is_directory(line, error)) folders.push_back(line);
  return folders;
}

void remember_folder(const std::string& folder) {
  constexpr std::size_t most_kept = 20;
  const fs::path file = kept_file();
  if (file.empty() || folder.find('\n') != folder.npos) return;
  std::vector<std::string> folders{folder};
  for (const std::string& one : recent_folders())
    if (one != folder && folders.size() < most_kept) folders.push_back(one);
  std::string text;
  for (const std::string& one : folders) text += one + '\n';
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  try {
    if (!error) write_users_file(file.string(), text);
  } catch (const std::exception&) {  // a list of convenience: no workbench fails for it
  }
}

}  // namespace parison::tools
