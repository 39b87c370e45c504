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

/// The curves of a DXF file in the order of the file, m, those without length included; `layer` empty for all layers,
/// `unit` of a drawing unit in m.
std::vector<core::Segment> read_dxf(const core::CaseNode& file, const std::string& path, const std::string& layer,
                                    double unit);

/// The curves of a section in a STEP file, m; the section must lie in a coordinate plane.
std::vector<core::Segment> read_step(const core::CaseNode& file, const std::string& path);

/// The part of a drawing that a table { file, from, via, to, unit, layer } selects.
std::vector<core::Segment> read_section(const core::CaseNode& node, const std::string& directory);

}  // namespace parison::forming
