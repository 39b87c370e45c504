#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

struct WatchRequest {
  std::string folder;
  int port = 8173;  ///< the next free one where it is taken
};

/// Serves the report of a result folder on this machine only, also while a run fills it, until it is stopped by Ctrl-C.
/// Returns the exit code.
int watch(const WatchRequest& request);

}  // namespace parison::tools
