#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "tools/report/data/run_data.hpp"

namespace parison::tools {

/// A result folder that may grow, end, vanish and begin anew while it is looked at.
class WatchedFolder {
 public:
  explicit WatchedFolder(std::string path) : path_(std::move(path)) {}

  /// A text that changes with what the folder shows.
  std::string stamp() const;
  /// The data of its page, of the last moment at which it could be read; `null` before there is a run.
  const std::string& data();

 private:
  std::string path_, data_ = "null", stamp_of_data_;
  ReportCache cache_;
};

}  // namespace parison::tools
