// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/answers/export_answer.hpp"

#include <filesystem>
#include <map>

#include "core/io/files.hpp"
#include "tools/program/child_process.hpp"
#include "tools/workbench/folder/left_files.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;

/// A folder that goes with its last use.
struct PassingFolder {
  fs::path path = passing_folder();
  PassingFolder() = default;
  PassingFolder(const PassingFolder&) = delete;
  ~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

PageAnswer file_of(const fs::path& file) {
  PageAnswer answer;
  answer.type = "application/octet-stream";
  answer.body = core::read_text(file.string());
  return answer;
}

}  // namespace

PageAnswer export_answer(WorkbenchState& state, const std::string& name) {
  const std::map<std::string, std::string> options{{".step", "--step"}, {".stl", "--stl"}, {".inp", "--shell"}};
  const fs::path path(name), folder = state.folder.existing(path.parent_path().string());
  const std::string ending = path.extension().string();
  if (ending == ".csv") return file_of(state.folder.existing(name));
  const auto option = options.find(ending);
  if (option == options.end()) return refusal(404, "no such file");
  const PassingFolder passing;
  const fs::path file = passing.path / ("container" + ending);
  const ProgramOutput written =
      output_of_program({"/proc/self/exe", "export", folder.string(), option->second, file.string()});
  const std::string begin = "parison: ";
  const auto told = written.text.find(begin);
  if (written.code != 0) return refusal(422, written.text.substr(told == written.text.npos ? 0 : told + begin.size()));
  return file_of(file);
}

}  // namespace parison::tools
