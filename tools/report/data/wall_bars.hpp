#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "forming/study/comparison/finished_run.hpp"
#include "tools/report/data/result_folder.hpp"

namespace parison::tools {

/// The run of a folder as `parison compare` reads it, whichever command has made its coarser runs; nothing where it has
/// not completed, has none or a file of them is damaged.
std::optional<forming::FinishedRun> run_with_coarser(const std::string& folder);

/// Gives the quantities of its summary.json the errors by the coarser runs, where the run itself has estimated none.
void add_errors(const forming::FinishedRun& run, nlohmann::ordered_json& summary);

/// The wall of a run that has ended; both have a column `error_mm`, not a number where no bar is known.
struct WallTables {
  ResultTable heights;  ///< heights.csv
  ResultTable profile;  ///< thickness.csv
};

/// The error bar at a place of the outer side is the largest of those within a hundredth of its length: that of
/// the run and its coarser ones, as the bars of the quantities are (forming::bar_of_values).
WallTables wall_tables(const std::string& folder, const std::optional<forming::FinishedRun>& run);

}  // namespace parison::tools
