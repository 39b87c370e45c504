// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/scene_text.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "core/case/case_error.hpp"
#include "core/io/files.hpp"
#include "core/process/run_error.hpp"
#include "forming/report/files/case_copy.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

/// The words of a command as the shell takes them, with no quotes but single ones.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  bool quoted = false, inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool blank = !quoted && (c == ' ' || c == '\n');
    if (!blank && !inside) words.emplace_back();
    inside = !blank;
    if (blank) continue;
    if (c == '\'')
      quoted = !quoted;
    else if (c == '\\' && !quoted && i + 1 < text.size())
      words.back() += text[++i];
    else
      words.back() += c;
  }
  return words;
}

std::string command_path(const std::string& folder) {
  return forming::case_copy_folder(folder) + "/command.txt";
}

std::string text_if_there(const std::string& path) {
  std::error_code unreadable;
  return fs::is_regular_file(path, unreadable) ? core::read_text(path) : "";
}

}  // namespace

CaseCommand read_command(const std::string& text) {
  CaseCommand command;
  const auto words = words_of(text);
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] == "--accuracy") command.accuracy = words[i + 1];
    if (words[i] == "--set") command.overrides.push_back(words[i + 1]);
  }
  return command;
}

SceneOfRun read_scene_of(const std::string& folder) {
  SceneOfRun of;
  const std::string path = forming::case_copy_folder(folder) + "/case.toml";
  try {
    if (!fs::is_directory(folder))
      throw core::RunError(folder + ": no such folder, allowed is the result folder of a run");
    if (!fs::is_regular_file(path))
      throw core::RunError(folder + ": the folder has no copy of its case, allowed is the result folder of a run");
    const CaseCommand command = read_command(text_if_there(command_path(folder)));
    of.scene = forming::read_scene(path, command.accuracy, command.overrides);
    of.text = forming::describe_scene(*of.scene);
  } catch (const core::CaseError& error) {  // the rest of the report needs no case
    of.problem = error.what();
  } catch (const core::RunError& error) {
    of.problem = error.what();
  }
  return of;
}

std::string stamp_of_case(const std::string& folder) {
  return text_if_there(command_path(folder)) + text_if_there(forming::case_copy_folder(folder) + "/case.toml");
}

}  // namespace parison::tools
