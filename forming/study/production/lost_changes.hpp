#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/run/resume/case_differences.hpp"
#include "forming/scene/scene.hpp"

namespace parison::forming {

/// The changes of a case that settled production does not depend on: the temperatures at which its tools start, since
/// each container brings them nearer to those at which a tool gives off what it receives.
std::vector<std::string> lost_changes(const Scene& scene, const std::vector<CaseDifference>& settings);

/// What changes the temperatures of a tool in settled production, as the end of a sentence.
std::string what_settled_tools_depend_on(const std::string& key);

}  // namespace parison::forming
