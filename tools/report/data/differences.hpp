#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "forming/study/comparison/study_folder.hpp"

namespace parison::tools {

/// What `parison compare` says of runs beside the first of them, and of variants that did not settle: by the name of
/// each its rows, or the reason why it cannot be compared. Null for one run alone.
nlohmann::ordered_json differences_of(const std::vector<std::string>& folders, const std::vector<std::string>& names,
                                      const std::vector<forming::FailedVariant>& failed);

}  // namespace parison::tools
