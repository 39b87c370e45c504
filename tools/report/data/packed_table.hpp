#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json_fwd.hpp>

#include "tools/report/data/result_folder.hpp"
#include "tools/report/film/packed_bytes.hpp"

namespace parison::tools {

/// The columns of numbers of a table that are drawn, in single precision, of a long one every so many rows: the more
/// runs a page has, the fewer of each.
nlohmann::ordered_json pack_table(const ResultTable& table, std::size_t runs, PackedBytes& bytes);

}  // namespace parison::tools
