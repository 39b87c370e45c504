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

constexpr const char* checkpoint_file = "checkpoint.h5";

/// All that a text has in quotes.
std::set<std::string> quoted_words(const std::string& text) {
  std::set<std::string> found;
  const std::regex quoted("\"([^\"\n]+)\"|'([^'\n]+)'");
  for (auto match = std::sregex_iterator(text.begin(), text.end(), quoted); match != std::sregex_iterator(); ++match)
    found.insert((*match)[1].matched ? (*match)[1].str() : (*match)[2].str());
  return found;
}

/// A file that was read; null where it was not.
const core::ReadFile* find_file(const Scene& scene, const fs::path& path) {
  const std::string absolute = fs::absolute(path).lexically_normal().string();
  for (const core::ReadFile& file : *scene.files)
    if (file.path == absolute) return &file;
  return nullptr;
}

/// The checkpoint of a result folder that is named, as it was read: kept beside this copy of the case already, beside
/// the case or in the working folder; null where the word names none.
const core::ReadFile* named_checkpoint(const Scene& scene, const std::string& word) {
  const std::string folder = fs::path(scene.files->front().path).parent_path().string();
  for (const fs::path& place : {fs::path(kept_results(folder, word)), fs::path(folder) / word, fs::path(word)})
    if (const core::ReadFile* file = find_file(scene, place / checkpoint_file)) return file;
  return nullptr;
}

void write_copy(const fs::path& to, const std::string& content) {
  fs::create_directories(to.parent_path());
  core::replace_file(to.string(), content, core::Reach::system);  // a resumed run writes it anew
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
  const fs::path folder = case_copy_folder(directory), own = scene.files->front().path;
  std::error_code error;
  if (fs::equivalent(own, folder / "case.toml", error)) return;
  const std::string& text = scene.files->front().content;
  std::string command = fmt::format("parison run case --accuracy {}", in_quotes(scene.accuracy_name));
  std::string naming = text;
  for (const std::string& assignment : scene.overrides) {
    command += " --set " + in_quotes(assignment);
    naming += '\n' + assignment;
  }
  write_copy(folder / "case.toml", text);
  for (const core::ReadFile& file : *scene.files)
    if (const fs::path named = fs::path(file.path).lexically_relative(own.parent_path());
        file.path != own && *named.begin() != ".." && named.filename() != checkpoint_file)
      write_copy(folder / named, file.content);
  std::set<std::string> words = quoted_words(naming);
  for (const std::string& assignment : scene.overrides)  // a value may stand there without quotes
    words.insert(std::string(core::trimmed(assignment.substr(assignment.find('=') + 1))));
  for (const std::string& word : words)
    if (const core::ReadFile* checkpoint = named_checkpoint(scene, word))
      write_copy(fs::path(kept_results(folder.string(), word)) / checkpoint_file, checkpoint->content);
  write_copy(folder / "command.txt", command + '\n');
}

}  // namespace parison::forming
