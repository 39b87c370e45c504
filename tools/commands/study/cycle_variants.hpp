#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <optional>
#include <string>

#include "forming/study/production/wanted_cooling.hpp"
#include "tools/commands/study/cycle.hpp"

namespace parison::tools {

/// What `parison cycle` is asked for, in numbers.
struct CyclePlan {
  std::optional<double> seconds;  ///< from one container to the next; none: that of the case
  double tolerance;               ///< K
  std::map<std::string, int> sets;
  std::vector<forming::WantedTool> wanted = {};
};

/// Settles production of the case and of each variant, compares the containers and prints which differences are real.
/// All variants are read before anything runs. Returns the exit code.
int cycle_variants(const CycleRequest& request, const CyclePlan& plan);

}  // namespace parison::tools
