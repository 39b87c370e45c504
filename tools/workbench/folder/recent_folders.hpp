#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::tools {

/// The folders that this user has opened in a workbench and that are still there, newest first. They are kept in
/// `parison/workbench_folders` of $XDG_STATE_HOME, which is ~/.local/state without it.
std::vector<std::string> recent_folders();

/// Puts a folder at their head; nothing where the user has no place that can be written.
void remember_folder(const std::string& folder);

}  // namespace parison::tools
