#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines from drawings; private to the files that read a scene.
#include <string>
#include <vector>

#include "core/case/case_file.hpp"
#include "core/mesh/profile.hpp"

namespace parison::forming {

/// The most lines and arcs that an outline or a drawing may have: what follows takes their number squared.
inline constexpr std::size_t max_segments = 20'000;

/// Diagonal of the box around curves in any order, m.
double size_of(std::vector<core::Segment> curves);

/// The curves of a DXF file in the order of the file, m, those without length included: of the `layer` that the table
/// of the drawing names or of all that are shown, in its `unit` or that of the file. `notes` gets a sentence about what
/// was left out.
std::vector<core::Segment> read_dxf(const core::CaseTable& table, const std::string& path,
                                    std::vector<std::string>& notes);

/// The curves of a section in a STEP file, m: those in a coordinate plane, or the section of a solid by a half plane
/// from its axis, which `is_cut` tells. `notes` gets a sentence about the axis that was found.
std::vector<core::Segment> read_step(const core::CaseTable& table, const std::string& path, bool& is_cut,
                                     std::vector<std::string>& notes);

/// The part of a drawing that a table { file, from, via, to, unit, layer, origin, axis, turn, gap } selects. `notes`
/// gets a sentence for what was not taken just as it was drawn.
std::vector<core::Segment> read_section(const core::CaseNode& node, const std::string& directory,
                                        std::vector<std::string>& notes);

}  // namespace parison::forming
