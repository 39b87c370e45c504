// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/workbench/folder/left_files.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "core/case/number.hpp"
#include "core/process/run_error.hpp"

namespace parison::tools {

namespace fs = std::filesystem;

std::string passing_name(const std::string& begin, const std::string& end) {
  return fmt::format("{}{}_{}", begin, getpid(), end);
}

void remove_left(Left what, const std::string& folder, const std::string& begin) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    if (name.compare(0, begin.size(), begin) != 0) continue;
    const std::string process = name.substr(begin.size(), name.find('_', begin.size()) - begin.size());
    std::error_code ignored;
    if (!core::parse_number<int>(process) || fs::exists("/proc/" + process) || entry.is_symlink(ignored)) continue;
    if (what == Left::file && entry.is_regular_file(ignored)) fs::remove(entry.path(), ignored);
    if (what == Left::folder && entry.is_directory(ignored)) fs::remove_all(entry.path(), ignored);
  }
}

std::string passing_folder() {
  const std::string prefix = "parison_workbench_";
  const fs::path memory("/dev/shm"), place = access(memory.c_str(), W_OK) == 0 ? memory : fs::temp_directory_path();
  remove_left(Left::folder, place.string(), prefix);
  std::string name = (place / passing_name(prefix, "XXXXXX")).string();
  if (!mkdtemp(name.data())) throw core::RunError(name + ": no folder can be made for passing files");
  return name;
}

}  // namespace parison::tools
