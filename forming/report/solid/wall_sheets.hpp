#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/report/solid/spline_patch.hpp"
#include "forming/solid/solid_state.hpp"

namespace parison::forming {

/// The surface of the whole container as smooth patches that meet, mm: inner side, outer side and rim, those of a side
/// in eighths of the turn around a square of four at the axis, or of narrow sectors one each. Throws core::RunError
/// where the sector is neither a whole number of quarters nor an even part of the turn.
std::vector<SplinePatch> wall_patches(const SolidState& solid);

}  // namespace parison::forming
