#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

namespace parison::forming {

/// One of the runs that were made to reach an accuracy.
struct ControlledRun {
  double factor;           ///< edges and steps, in units of those of the draft preset
  double cpu_seconds = 0;  ///< of the run
  bool completed = true;   ///< whether it came to its end
  double estimate = std::numeric_limits<double>::infinity();  ///< error of this run, a share
  bool confirmed = false;  ///< whether enough runs take part in the estimate to rest on it
};

/// How an accuracy that was asked for was reached, or was not.
struct AccuracyRecord {
  double target;  ///< share of the wall in the mean and of the heat into the tools
  std::vector<ControlledRun> runs;
  bool reached() const { return !runs.empty() && runs.back().confirmed && runs.back().estimate <= target; }
};

}  // namespace parison::forming
