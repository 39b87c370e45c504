// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/report/files/case_copy.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <regex>
#include <set>

#include "core/case/given_file.hpp"
#include "core/io/files.hpp"
#include "core/process/run_error.hpp"
#include "forming/scene/kept_results.hpp"

namespace parison::forming {
namespace {

namespace fs = std::filesystem;

/// All that a text has in quotes.
std::set<std::string> quoted_words(const std::string& text) {
  std::set<std::string> found;
  const std::regex quoted("\"([^\"\n]+)\"|'([^'\n]+)'");
  for (auto match = std::sregex_iterator(text.begin(), text.end(), quoted); match != std::sregex_iterator(); ++match)
    found.insert((*match)[1].matched ? (*match)[1].str() : (*match)[2].str());
  return found;
}

/// The regular files below the folder of a case among them, by their relative paths.
std::set<fs::path> named_files(const std::set<std::string>& words, const fs::path& folder) {
  std::set<fs::path> found;
  for (const std::string& word : words) {
    const fs::path named = fs::path(word).lexically_normal();
    std::error_code unreadable;
    const bool is_below = named.is_relative() && !named.empty() && *named.begin() != "..";
    if (is_below && fs::is_regular_file(folder / named, unreadable)) found.insert(named);
  }
  return found;
}

/// The checkpoint of a result folder that is named, kept beside this copy of the case already, beside the case or in
/// the working folder; empty where the word names none.
fs::path named_checkpoint(const std::string& word, const std::string& folder) {
  std::error_code unreadable;
  for (const fs::path& place : {fs::path(kept_results(folder, word)), fs::path(folder) / word, fs::path(word)})
    if (const fs::path file = place / "checkpoint.h5"; fs::is_regular_file(file, unreadable)) return file;
  return {};
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
  std::set<std::string> words = quoted_words(naming);
  for (const std::string& assignment : scene.overrides)  // a value may stand there without quotes
    words.insert(std::string(core::trimmed(assignment.substr(assignment.find('=') + 1))));
  for (const fs::path& named : named_files(words, scene.directory))
    copy_to(fs::path(scene.directory) / named, folder / named);
  for (const std::string& word : words)
    if (const fs::path checkpoint = named_checkpoint(word, scene.directory); !checkpoint.empty())
      copy_to(checkpoint, fs::path(kept_results(folder.string(), word)) / "checkpoint.h5");
  core::replace_file((folder / "command.txt").string(), command + '\n');
}

}  // namespace parison::forming
