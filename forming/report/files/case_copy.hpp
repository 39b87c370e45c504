#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Folder of a result folder that holds its case.
std::string case_copy_folder(const std::string& directory);

/// Writes the case file, the files of its folder and the states at the end of other results that it names into the
/// result folder, as they were read for the scene, with the command that runs them.
void copy_case(const Scene& scene, const std::string& directory);

}  // namespace parison::forming
