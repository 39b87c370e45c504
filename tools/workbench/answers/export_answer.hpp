#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "tools/server/page_server.hpp"
#include "tools/workbench/answers/workbench_state.hpp"

namespace parison::tools {

/// A file of results for other programs: "results/jar/container.step", .stl or .inp as `parison export` writes it, or a
/// table of the run, .csv.
PageAnswer export_answer(WorkbenchState& state, const std::string& name);

}  // namespace parison::tools
