#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/server/page_server.hpp"
#include "tools/workbench/answers/workbench_state.hpp"

namespace parison::tools {

/// The answer of the workbench: the page "" and its files "page/...", pictures "bundled/NAME.png", live reports
/// "result/NAME/..." and, by POST, "api/QUESTION".
PageAnswer page_answer(WorkbenchState& state, const PageRequest& request);

/// Whether a report is asked for, which takes long.
bool is_report(const PageRequest& request);

}  // namespace parison::tools
