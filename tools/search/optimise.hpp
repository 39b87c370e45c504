#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

/// What `parison optimise` is asked for.
struct OptimiseRequest {
  std::string file, output;
  int jobs = 0;  ///< 0: as many as there are cores
  bool check = false;
};

/// Searches for the values of a case that a goal file wants, or goes on with it; confirms the answer and writes it as a
/// case and as drawings. Returns the exit code.
int optimise(const OptimiseRequest& request);

}  // namespace parison::tools
