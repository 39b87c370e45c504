#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <string>
#include <vector>

namespace parison::tools {

/// What `parison uncertainty` is asked for.
struct UncertaintyRequest {
  std::string case_path, accuracy = "draft", output;
  std::vector<std::string> overrides;
  std::size_t runs = 0;  ///< 0: as many as usual
  std::uint64_t seed = 1;
  int jobs = 0;  ///< 0: as many as there are cores
  bool list = false;
};

/// Runs a case with values drawn from its tolerances, or what is left of these runs, and says what the tolerances do to
/// each quantity. Returns the exit code.
int uncertainty(const UncertaintyRequest& request);

}  // namespace parison::tools
