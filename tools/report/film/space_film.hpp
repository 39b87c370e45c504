#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/report/data/result_folder.hpp"
#include "tools/report/film/file_cache.hpp"
#include "tools/report/film/packed_bytes.hpp"
#include "tools/report/film/solid_surface.hpp"

namespace parison::tools {

/// The surface of glass in space at the outputs of a run, quantised into `bytes`: places and the wall to a 65535th of
/// their range, other fields to a 255th. Outputs are left out, evenly but for the ends of stages, where all would take
/// more than `budget` bytes. Null where the run has none.
nlohmann::ordered_json pack_space_film(const ResultFolder& folder, FileCache<SolidSurface>& cache, std::size_t budget,
                                       PackedBytes& bytes, std::vector<std::string>& problems);

}  // namespace parison::tools
