#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::tools {

/// The section of a scene as SVG: a panel for each set of tools that is active together, with their names, the stages,
/// the axis, and in the first the glass; a plunger that closes a cavity is dashed where it ends.
std::string section_picture(const forming::Scene& scene);

}  // namespace parison::tools
