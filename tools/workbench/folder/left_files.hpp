#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::tools {

/// The name of something that is there only while this process needs it: `begin`, its id, `_`, `end`.
std::string passing_name(const std::string& begin, const std::string& end);

/// What a killed process leaves: single files among those of the user, whole folders in a place for passing ones.
enum class Left { file, folder };

/// Removes from a folder what has such a name of a process that is no more.
void remove_left(Left what, const std::string& folder, const std::string& begin);

/// A new folder for what only this process needs, in memory where the system has such a place; what killed ones have
/// left there is removed.
std::string passing_folder();

}  // namespace parison::tools
