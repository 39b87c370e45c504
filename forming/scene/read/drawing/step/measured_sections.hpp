#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "core/solid/hex_mesh.hpp"
#include "forming/scene/scene.hpp"

// Sections of a mould from its solid; private to the files that read a scene.

namespace parison::forming {

/// Corners counterclockwise as seen from outside, m.
using Triangle = std::array<core::Vector3, 3>;

/// The surface of the solids in a STEP file, in the frame of their axis and of the half plane of { file, axis, turn }.
std::vector<Triangle> read_step_triangles(const core::CaseTable& table, const std::string& path);

/// The sections of a mould that a table { file, origin, axis, turn } selects, at the heights of the tool's outline.
/// Refuses a cavity without two planes of symmetry, or whose wall is not all around, or away from what the sections
/// make of it; the tool gets a note about how near that is.
core::SectionFamily measured_sections(const core::CaseTable& table, const std::string& directory, Tool& tool);

}  // namespace parison::forming
