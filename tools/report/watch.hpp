#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/report.hpp"

namespace parison::tools {

/// What `parison report` is asked for.
struct LiveReportRequest : ReportRequest {
  bool live = false;
  int port = 8173;  ///< the next free one where it is taken
};

/// Serves the report of one result folder on this machine only, also while a run fills it, until it is stopped by
/// Ctrl-C. Returns the exit code.
int watch(const LiveReportRequest& request);

}  // namespace parison::tools
