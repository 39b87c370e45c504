#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

/// What `parison workbench` is asked for.
struct WorkbenchRequest {
  std::string folder = ".";
  int port = 8180;  ///< the next free one where it is taken
  bool no_browser = false;
};

/// Serves the workbench of a folder on this machine only until it is stopped by Ctrl-C. Returns the exit code.
int workbench(const WorkbenchRequest& request);

}  // namespace parison::tools
