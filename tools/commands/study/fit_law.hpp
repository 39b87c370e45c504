#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// What `parison fit-law` was asked for.
struct FitLawRequest {
  std::string data;                ///< CSV file
  std::vector<std::string> fixed;  ///< "NAME=VALUE"
  std::string case_path;           ///< its glass gives the viscosity; may be empty
  bool relative = false;
};

/// Fits and prints the constants with their intervals, the residuals, warnings and the lines for a case file; 0.
int fit_law(const FitLawRequest& request);

}  // namespace parison::tools
