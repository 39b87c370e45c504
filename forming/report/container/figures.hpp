#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace parison::forming {

/// A number with so many decimals, and with more where they would leave a small one fewer than four figures.
inline std::string figures(double value, int decimals) {
  const int whole = value > 0 ? static_cast<int>(std::floor(std::log10(value))) + 1 : 1;
  return fmt::format("{:.{}f}", value, std::max(decimals, 4 - whole));
}

}  // namespace parison::forming
