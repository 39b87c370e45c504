#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

namespace parison::core {

/// Piecewise linear function, its ends held; one entry makes a constant.
struct Table {
  std::vector<double> x, y;

  double operator()(double at) const;
  double derivative(double at) const;
  /// Integral from x.front() to `at` (from 0 for a constant).
  double integral(double at) const;
};

inline Table constant(double value) {
  return {{0.0}, {value}};
}

}  // namespace parison::core
