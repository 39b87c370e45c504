#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <vector>

#include "forming/scene/container/free_space.hpp"

namespace parison::forming {

/// What ends a range of shifts: the place of a solid that the moved body meets there.
struct Stop {
  double shift;         ///< m along the axis, infinite where nothing is met
  std::size_t met = 0;  ///< index of the solid
  core::Point at = core::Point::Zero();
};

/// A range of shifts along the axis at which a body overlaps none of the solids.
struct FreeShifts {
  Stop low{-std::numeric_limits<double>::infinity()}, high{std::numeric_limits<double>::infinity()};
};

/// All such ranges of an axisymmetric body, in order; every boundary counts. Nothing where the outlines are too fine.
std::vector<FreeShifts> free_shifts(const Solid& moved, const std::vector<Solid>& solids);

}  // namespace parison::forming
