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

/// Mean between two places, the first below the second; exact wherever the entries lie.
double mean(const Table& table, double from, double to);

/// The x of the entries that a polygon needs which misses no entry by more than `share` of the range of y, its ends
/// included: the corners that count, however many entries a measured curve has (U. Ramer, Computer Graphics and Image
/// Processing 1 (1972) 244-256; D. H. Douglas, T. K. Peucker, Cartographica 10 (1973) 112-122; here the distance is
/// along y).
std::vector<double> corners(const Table& table, double share);

/// The x at which dy/dx jumps by more than this share of the largest dy/dx: the corners of a curve that is otherwise
/// smooth, however many entries it is given by.
std::vector<double> kinks(const Table& table, double share);

inline Table constant(double value) {
  return {{0.0}, {value}};
}

}  // namespace parison::core
