#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// Names of the runs in some folders that tell them apart: the last word of each, with the folders above it where
/// several end alike.
std::vector<std::string> run_names(const std::vector<std::string>& folders);

/// The result folders of runs below a folder that is none itself, as that of a what-if, in alphabetical order.
std::vector<std::string> run_folders_in(const std::string& folder);

/// A sentence that names them; empty where there is none.
std::string run_folders_hint(const std::string& folder);

}  // namespace parison::tools
