#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

/// What `parison sweep` is asked for.
struct SweepRequest {
  std::string file, output;
  int jobs = 0;  ///< 0: as many as there are cores
  bool list = false;
};

/// Runs a sweep, or what is left of it, and writes the table of its results. Returns the exit code.
int sweep(const SweepRequest& request);

}  // namespace parison::tools
