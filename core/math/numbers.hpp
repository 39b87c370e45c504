#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

namespace parison::core {

/// What a number is where there is nothing to measure.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();
inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double millimetre = 1e-3;  ///< m

}  // namespace parison::core
