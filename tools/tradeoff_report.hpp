#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/ladder.hpp"

namespace parison::tools {

/// Reads the results of a ladder's rungs and writes tradeoff.csv, tradeoff.json, tradeoff.md and, where Python can, the plot
/// into the folder; prints the table. False when the reference or the base has not completed.
bool report_tradeoff(const std::string& folder, const std::vector<forming::Rung>& rungs, const std::string& base);

}  // namespace parison::tools
