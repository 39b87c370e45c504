#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// A page with all that it needs in itself: template, styles, scripts and the plotting library of share/parison, a
/// title, and the data as report_data makes them or `null`. Throws core::RunError where those files are missing.
std::string page_text(const std::string& title, const std::string& data);

/// A text as HTML shows it.
std::string html_text(const std::string& text);

struct ReportRequest {
  std::vector<std::string> folders;
  std::string output;       ///< empty: report.html in the first folder
  std::string search = {};  ///< the course of the search that the runs come from, JSON; empty: none
};

/// Writes one page on the runs of some result folders and says where. Returns the exit code.
int report(const ReportRequest& request);

/// What `parison report` is asked for.
struct LiveReportRequest : ReportRequest {
  bool live = false;
  int port = 8173;  ///< the next free one where it is taken
};

/// Serves the report of one result folder on this machine only, also while a run fills it, until it is stopped by
/// Ctrl-C. Returns the exit code.
int watch(const LiveReportRequest& request);

}  // namespace parison::tools
