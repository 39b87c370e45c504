#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "tools/report/data/run_data.hpp"
#include "tools/server/page_server.hpp"

namespace parison::tools {

/// Where a report and what it asks for may come from; `ancestors` may show it in a frame.
std::string report_policy(const std::string& ancestors);

/// A result folder that may grow, end, vanish and begin anew while it is looked at.
class WatchedFolder {
 public:
  explicit WatchedFolder(std::string path);

  /// The page ("", for which `ancestors` may show it in a frame), its "data", or the "stamp" that changes with them.
  PageAnswer answer(const std::string& target, const std::string& ancestors);

 private:
  std::string stamp() const;
  /// The data of its page, of the last moment at which it could be read; `null` before there is a run.
  const std::string& data();

  std::string path_, page_, data_ = "null", stamp_of_data_;
  ReportCache cache_;
};

}  // namespace parison::tools
