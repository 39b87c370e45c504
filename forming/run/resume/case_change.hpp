#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// The first key in which the case of a scene differs from the one in a folder with these assignments, where a run that
/// stands in the stage `stage` has used it already: anything but `output`, later stages and tools that no stage up to
/// this one uses, with the dimensions that only these name. Empty where the run can go on with the case as it is now.
std::string used_change(const std::string& folder_before, const std::vector<std::string>& overrides_before,
                        const Scene& scene, Index stage);

/// Those of these tools, as indices into Scene::tools, that the change may have made others.
std::vector<Index> changed_unused_tools(const std::string& folder_before,
                                        const std::vector<std::string>& overrides_before, const Scene& scene,
                                        Index stage);

}  // namespace parison::forming
