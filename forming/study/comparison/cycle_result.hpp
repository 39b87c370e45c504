#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/run/resume/case_differences.hpp"

namespace parison::forming {

/// What a search for settled production has left in its folder, as a comparison sees it.
struct CycleResult {
  std::string reason;                   ///< why there is no settled container; empty where there is
  std::vector<CaseDifference> changes;  ///< in which its case differs from that of the base
  std::string not_possible;             ///< why no machine can have such tools; empty where one can
};

/// Reads cycle.json of the folder of a cycle, or of a variant of one; nothing where there is none.
std::optional<CycleResult> read_cycle_result(const std::string& folder);

}  // namespace parison::forming
