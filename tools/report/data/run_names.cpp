// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/run_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "tools/report/data/result_folder.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

/// The words of a path without "." and "..".
std::vector<std::string> words_of(const std::string& folder) {
  std::vector<std::string> words;
  for (const fs::path& word : fs::absolute(folder).lexically_normal())
    if (!word.empty() && word != "/") words.push_back(word.string());
  return words;
}

/// The last `count` words of a path.
std::string last_words(const std::vector<std::string>& words, std::size_t count) {
  const std::size_t first = words.size() - std::min(count, words.size());
  return fmt::format("{}", fmt::join(words.begin() + static_cast<std::ptrdiff_t>(first), words.end(), "/"));
}

/// Adds the result folders below a folder, down to so many levels; what lies in one belongs to that run.
void add_run_folders(const fs::path& folder, int levels, std::vector<std::string>& found) {
  std::error_code unreadable;
  for (const auto& entry : fs::directory_iterator(folder, unreadable)) {
    if (!entry.is_directory(unreadable)) continue;
    if (is_result_folder(entry.path().string()))
      found.push_back(entry.path().string());
    else if (levels > 1)
      add_run_folders(entry.path(), levels - 1, found);
  }
}

}  // namespace

std::vector<std::string> run_names(const std::vector<std::string>& folders) {
  std::vector<std::vector<std::string>> words;
  std::size_t longest = 1;
  for (const std::string& folder : folders) {
    words.push_back(words_of(folder));
    longest = std::max(longest, words.back().size());
  }
  std::vector<std::string> names;
  for (const auto& own : words) {
    std::size_t count = 1;
    const auto is_alike = [&](const auto& other) { return last_words(other, count) == last_words(own, count); };
    while (count < longest && std::count_if(words.begin(), words.end(), is_alike) > 1) ++count;
    names.push_back(last_words(own, count));
  }
  return names;
}

std::vector<std::string> run_folders_in(const std::string& folder) {
  constexpr int levels = 2;  // a what-if with --resolve has a folder for each accuracy
  std::vector<std::string> found;
  if (!is_result_folder(folder)) add_run_folders(folder, levels, found);
  std::sort(found.begin(), found.end());
  return found;
}

std::string run_folders_hint(const std::string& folder) {
  constexpr std::size_t most = 12;
  std::vector<std::string> found = run_folders_in(folder);
  if (found.empty()) return {};
  const std::size_t more = found.size() - std::min(found.size(), most);
  found.resize(found.size() - more);
  return fmt::format("result folders in it are {}{}", fmt::join(found, ", "),
                     more > 0 ? fmt::format(" and {} more", more) : "");
}

}  // namespace parison::tools
