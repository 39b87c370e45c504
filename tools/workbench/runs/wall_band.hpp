#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "core/io/json.hpp"

namespace parison::tools {

/// Adds, as `wall`, the wall of a finished run along its outer side from the rim on: z, thickness, and with a table of
/// the wanted one (read_wall_table, a band where it has tolerances) the least and the most that is wanted there, mm.
/// Then also `outside`, the share of the length that is outside that band, and the farthest place: `worst_mm`, positive
/// where it is too thick, at `worst_z_mm`. `wanted_problem` says why a table is refused. Nothing without a wall.
void add_wall_band(const std::string& folder, const std::string& wanted_file, core::JsonWriter& json);

}  // namespace parison::tools
