#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::forming {

/// Tools of a changed case that overlap where they stand, in a stage in which both are active and rest, while those of
/// the base do not, as a sentence; empty where there are none. Tools that overlap in a stage of the base too are meant
/// to: their union counts.
std::string new_tool_overlap(const Scene& base, const Scene& changed);

}  // namespace parison::forming
