#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/process/run_error.hpp"

namespace parison::tools {

/// Files that have been read, so that a page that grows with a run reads each once.
template <class File>
class FileCache {
 public:
  using Reader = File (*)(const std::string&);
  explicit FileCache(Reader reader) : reader_(reader) {}

  /// Null where the file is missing or broken; `problems` then gets a sentence.
  std::shared_ptr<const File> read(const std::string& path, std::vector<std::string>& problems) {
    std::error_code missing;
    const auto written = std::filesystem::last_write_time(path, missing);
    const auto size = std::filesystem::file_size(path, missing);
    const auto stamp = missing ? "" : fmt::format("{} {}", size, written.time_since_epoch().count());
    Entry& entry = entries_[path];
    if (entry.stamp == stamp && entry.file) return entry.file;
    try {
      entry = {stamp, std::make_shared<const File>(reader_(path))};
      return entry.file;
    } catch (const core::RunError& error) {  // of one output: the others are shown
      constexpr std::size_t most = 5;
      if (problems.size() < most) problems.emplace_back(error.what());
      return nullptr;
    }
  }

 private:
  struct Entry {
    std::string stamp;  ///< size and time of the file
    std::shared_ptr<const File> file;
  };
  Reader reader_;
  std::map<std::string, Entry> entries_;
};

}  // namespace parison::tools
