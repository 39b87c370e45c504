// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/files/case_copy.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <regex>
#include <set>

#include "core/io/files.hpp"
#include "core/process/run_error.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

/// The regular files below the folder of a case that its text, or an assignment, has in quotes, by their relative
/// paths.
std::set<fs::path> named_files(const std::string& text, const fs::path& folder) {
  std::set<fs::path> found;
  const std::regex quoted("\"([^\"\n]+)\"|'([^'\n]+)'");
  for (auto match = std::sregex_iterator(text.begin(), text.end(), quoted); match != std::sregex_iterator(); ++match) {
    const fs::path named = fs::path((*match)[1].matched ? (*match)[1].str() : (*match)[2].str()).lexically_normal();
    std::error_code unreadable;
    const bool is_below = named.is_relative() && !named.empty() && *named.begin() != "..";
    if (is_below && fs::is_regular_file(folder / named, unreadable)) found.insert(named);
  }
  return found;
}

void copy_to(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  if (!error) fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (error)
    throw core::RunError(fmt::format("{}: cannot be copied to {}: {}", from.string(), to.string(), error.message()));
}

/// A word as the shell takes it.
std::string in_quotes(const std::string& word) {
  return '\'' + std::regex_replace(word, std::regex("'"), "'\\''") + '\'';
}

}  // namespace

std::string case_copy_folder(const std::string& directory) {
  return directory + "/case";
}

void copy_case(const Scene& scene, const std::string& directory) {
  const fs::path folder = case_copy_folder(directory);
  std::error_code error;
  if (!fs::is_regular_file(scene.file, error) || fs::equivalent(scene.file, folder / "case.toml", error)) return;
  const std::string text = core::read_text(scene.file);
  std::string command = fmt::format("parison run case --accuracy {}", in_quotes(scene.accuracy_name));
  std::string naming = text;
  for (const std::string& assignment : scene.overrides) {
    command += " --set " + in_quotes(assignment);
    naming += '\n' + assignment;
  }
  copy_to(scene.file, folder / "case.toml");
  for (const fs::path& named : named_files(naming, scene.directory))
    copy_to(fs::path(scene.directory) / named, folder / named);
  core::replace_file((folder / "command.txt").string(), command + '\n');
}

}  // namespace parison::forming
