#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace parison::tools {

/// What `parison compare` says of runs beside the first of them: by the name of each run its rows, or the reason why it
/// cannot be compared. Null for one run.
nlohmann::ordered_json differences_of(const std::vector<std::string>& folders, const std::vector<std::string>& names);

}  // namespace parison::tools
