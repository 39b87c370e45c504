#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/mesh/profile.hpp"
#include "forming/study/search/case/search_case.hpp"

namespace parison::forming {

/// The outline as a DXF file (R12) in mm, r to the right and z up, its lines and arcs on a layer.
std::string dxf_text(const core::Profile& outline, const std::string& layer);

/// Writes the case with the values of a place into the folder `case` of `output`, complete with the files that it
/// names, and a drawing TOOL.dxf of each tool whose outline is not that of the case without them. Returns the names.
std::vector<std::string> write_case(const SearchCase& search, const Eigen::VectorXd& at, const std::string& output);

}  // namespace parison::forming
