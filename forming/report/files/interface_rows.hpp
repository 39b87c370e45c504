#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/mesh/interface_point.hpp"
#include "forming/scene/scene.hpp"
#include "forming/state/state.hpp"

namespace parison::forming {

/// Line of column names of interface.csv.
std::string interface_header();

/// Lines of interface.csv, along the glass surface from its start: up to four for each glass edge and tool; empty
/// without heat.
std::string interface_lines(const Scene& scene, const State& state, const std::vector<core::InterfacePoint>& interface);

}  // namespace parison::forming
