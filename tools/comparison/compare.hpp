#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::tools {

/// What `parison compare` is asked for.
struct CompareRequest {
  std::string base;
  std::vector<std::string> others;
  std::string quantity;  ///< that the last table ranks the runs by; empty: the thinnest wall
  std::string output;    ///< folder for the files; empty for none
};

/// Compares result folders. Returns the exit code, like the other.
int compare(const CompareRequest& request);

/// What `parison what-if` is asked for.
struct WhatIfRequest {
  std::string case_path;  ///< or the folder of a finished run, which then is the base
  std::string accuracy;   ///< empty: standard, or that of the finished run
  std::string output, quantity;
  std::vector<std::string> overrides;  ///< of all runs
  std::vector<forming::WhatIfVariant> variants;
  std::string resolve;  ///< "0.02 mm" or "QUANTITY=VALUE UNIT"; empty for none
  bool twice = false;   ///< each difference is the mean of two
  int jobs = 1;
};

/// Runs a case and changes of it, and compares them.
int what_if(const WhatIfRequest& request);

}  // namespace parison::tools
