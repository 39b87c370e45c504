#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "forming/scene/scene.hpp"
#include "tools/report/data/result_folder.hpp"

namespace parison::tools {

/// The wall of a run that has ended; both have a column `error_mm`, not a number where no bar is known.
struct WallTables {
  ResultTable heights;  ///< heights.csv
  ResultTable profile;  ///< thickness.csv
};

/// The error bar at a place of the outer side is the largest of those within a hundredth of its length: that of
/// the run and the coarser ones that completed, as the bars of the quantities are (forming::bar_of_values).
WallTables wall_tables(const std::string& folder, const nlohmann::ordered_json& summary,
                       const std::optional<forming::Scene>& scene);

}  // namespace parison::tools
