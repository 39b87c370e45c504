#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/mesh/interface_point.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"
#include "forming/state/tool_surface.hpp"

namespace parison::forming {

/// The surfaces of all tools of a run.
std::vector<ToolSurface> tool_surfaces(const Scene& scene, const State& state);

/// The boundaries of a tool whose heat is reported: those with cooling or a given temperature.
std::vector<std::size_t> reported_faces(const Tool& tool);

/// Line of column names of tools.csv, and the row of a state as a line; only tools that carry heat have columns.
std::string tool_header(const Scene& scene);
std::string tool_line(const Scene& scene, const State& state, const std::vector<ToolSurface>& surfaces);

/// Line of column names of interface.csv.
std::string interface_header();

/// Lines of interface.csv, along the glass surface from its start: up to four for each glass edge and tool; empty
/// without heat.
std::string interface_lines(const Scene& scene, const State& state, const std::vector<core::InterfacePoint>& interface);

}  // namespace parison::forming
