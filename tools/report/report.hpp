#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

struct ReportRequest {
  std::vector<std::string> folders;
  std::string output;       ///< empty: report.html in the first folder
  std::string search = {};  ///< the course of the search that the runs come from, JSON; empty: none
};

/// Writes one page on the runs of some result folders and says where. Returns the exit code.
int report(const ReportRequest& request);

}  // namespace parison::tools
