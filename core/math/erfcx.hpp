#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

namespace parison::core {

/// exp(x^2) erfc(x) for x from 0; by its leading terms, off by 5e-6 of it at most, where that would overflow.
inline double erfcx(double x) {
  return x < 20 ? std::exp(x * x) * std::erfc(x) : (1 - 0.5 / (x * x)) / (x * std::sqrt(M_PI));
}

}  // namespace parison::core
