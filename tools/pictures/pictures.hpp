#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::tools {

/// The section of a scene as SVG: a panel for each set of tools that is active together, with their names, the stages,
/// the axis, and in the first the glass; a plunger that closes a cavity is dashed where it ends.
std::string section_picture(const forming::Scene& scene);

/// SVG of the stages, the tools and the pressures over time: with a timing over the degrees of one cycle, in which what
/// lasts beyond its end goes on at its start in another colour, and with the events; else over seconds.
std::string timing_picture(const forming::Scene& scene);

}  // namespace parison::tools
