#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "core/mesh/profile.hpp"

namespace parison::forming {

/// The points of a CSV file with a heading such as r_mm,z_mm, as lines of which only the end is known.
std::vector<core::Segment> read_csv_points(const core::CaseNode& node, const std::string& directory);

/// The arcs of a smooth curve through such points, behind the point where it starts; `node` asks for it.
std::vector<core::Segment> smoothed(const core::CaseNode& node, const std::vector<core::Segment>& points);

}  // namespace parison::forming
