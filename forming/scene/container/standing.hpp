#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/container/free_space.hpp"

namespace parison::forming {

/// Why a container with the outside of a closed mould falls over, a sentence; empty where it stands. A round bottom
/// rolls until its centre of curvature lies above the centre of mass, here that of a thin even wall; a flat bottom or a
/// foot ring has none so low. `up`: 1 where it stands along the axis, -1 against it.
std::string why_it_falls(const FreeRegion& mould, int up);

}  // namespace parison::forming
