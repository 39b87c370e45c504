#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

namespace parison::core {

/// Piecewise linear function, constant beyond its first and last entry; one entry makes a constant. Units are those of
/// x and y, the x rise.
struct Table {
  std::vector<double> x, y;

  double operator()(double at) const;
  /// dy/dx, that of the interval to the right at an entry; zero beyond the ends.
  double derivative(double at) const;
  /// Integral from x.front() to `at` (from 0 for a constant).
  double integral(double at) const;
};

/// The x at which dy/dx jumps by more than this share of the largest dy/dx: the corners of a curve that is otherwise
/// smooth, however many entries it is given by.
std::vector<double> kinks(const Table& table, double share);

inline Table constant(double value) {
  return {{0.0}, {value}};
}

}  // namespace parison::core
