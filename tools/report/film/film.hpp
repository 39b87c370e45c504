#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/report/data/result_folder.hpp"
#include "tools/report/film/file_cache.hpp"
#include "tools/report/film/packed_bytes.hpp"
#include "tools/report/film/vtu_file.hpp"

namespace parison::tools {

/// The sections of glass and active tools at the outputs of a run, quantised into `bytes`: places to a 65535th of the
/// body's size, fields to a 255th of their range at that time. Outputs are left out, evenly but for the ends of
/// stages, where all would take more than `budget` bytes.
nlohmann::ordered_json pack_film(const ResultFolder& folder, FileCache<VtuFile>& cache, std::size_t budget,
                                 PackedBytes& bytes, std::vector<std::string>& problems);

}  // namespace parison::tools
