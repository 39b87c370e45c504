#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/report/data/result_folder.hpp"
#include "tools/report/film/packed_bytes.hpp"

namespace parison::tools {

/// The columns of numbers of a table that are drawn, in single precision, of a long one every so many rows: the more
/// runs a page has, the fewer of each.
nlohmann::ordered_json pack_table(const ResultTable& table, std::size_t runs, PackedBytes& bytes);

/// The production of each cycle whose containers are among the runs: cycle.json, and the tables of the settled cycle
/// and of the start. Empty without one.
nlohmann::ordered_json productions_of(const std::vector<std::string>& folders, PackedBytes& bytes);

}  // namespace parison::tools
