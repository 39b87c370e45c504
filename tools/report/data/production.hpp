#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/report/film/packed_bytes.hpp"

namespace parison::tools {

/// The production of each cycle whose containers are among the runs: cycle.json, and the tables of the settled cycle
/// and of the start. Empty without one.
nlohmann::ordered_json productions_of(const std::vector<std::string>& folders, PackedBytes& bytes);

}  // namespace parison::tools
