#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <vector>

#include "tools/report/data/result_folder.hpp"
#include "tools/report/film/vtu_file.hpp"

namespace parison::tools {

/// The entry nearest to a time, s.
std::size_t nearest(const std::vector<PvdEntry>& entries, double time);

/// The outputs to show: all where their bytes fit into the budget, else every so many, the last one and the ends of
/// the stages.
std::vector<std::size_t> kept_outputs(const ResultFolder& folder, const std::vector<PvdEntry>& entries, double bytes,
                                      std::size_t budget);

}  // namespace parison::tools
