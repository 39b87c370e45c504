#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/report/summary.hpp"

namespace parison::tools {

/// What `parison run`, `parison check` and `parison resume` are asked for.
struct RunRequest {
  std::string case_path;  ///< resume: empty for the case as it was
  std::string accuracy = "standard";
  std::vector<std::string> overrides;
  std::string output;    ///< result folder; run: empty for results/NAME
  std::string picture;   ///< check: SVG file, empty for none
  std::string after;     ///< resume: the stage from whose end, empty for the last checkpoint
  bool verbose = false;  ///< first all that `parison check` says
  bool error_bars = false;
  bool to_cold = false;       ///< run: cool the container after the last stage
  bool later_counts = false;  ///< run: of several assignments of one value the last one
  bool keep_going = false;    ///< exit code 0 also where the results are not trustworthy
};

/// Prints what a case needs. Like the others here it returns the exit code of the program.
int check(const RunRequest& request);

/// What a run says of its scene before it begins.
std::string opening(const RunRequest& request, const forming::Scene& scene);

/// Exit code of a run that completed, by its checks.
int code_of(const forming::RunFacts& facts, bool keep_going);

/// Runs a case into a new folder.
int run(const RunRequest& request);

/// Continues the run of a folder.
int resume(const RunRequest& request);

}  // namespace parison::tools
