#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/server/page_server.hpp"
#include "tools/workbench/answers/workbench_state.hpp"

namespace parison::tools {

/// The answer of the workbench: the page "" and its files "page/...", pictures "bundled/NAME.png", live reports
/// "result/NAME/...", files for other programs "export/NAME/FILE" and, by POST, "api/QUESTION".
PageAnswer page_answer(WorkbenchState& state, const PageRequest& request);

/// Whether a report or an export is asked for, which takes long.
bool takes_long(const PageRequest& request);

}  // namespace parison::tools
