#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "core/case/table.hpp"

namespace parison::core {

/// A quantity over time, s: a constant, or piecewise linear between given times and constant before the first and after
/// the last of them.
class TimeFunction {
 public:
  TimeFunction(double constant = 0) : constant_(constant) {}
  explicit TimeFunction(Table over_time)
      : over_time_(std::move(over_time)), corners_(corners(over_time_, corner_share)) {}

  bool is_constant() const { return over_time_.x.empty(); }

  double operator()(double time) const { return is_constant() ? constant_ : over_time_(time); }
  /// Rate of change per second; at one of the given times that of the interval after it.
  double derivative(double time) const { return is_constant() ? 0 : over_time_.derivative(time); }
  double min() const { return is_constant() ? constant_ : *std::min_element(over_time_.y.begin(), over_time_.y.end()); }
  double max() const { return is_constant() ? constant_ : *std::max_element(over_time_.y.begin(), over_time_.y.end()); }

  /// Largest size, without sign.
  double max_size() const { return std::max(max(), -min()); }
  /// Mean over a time, exact whatever the given times; a constant keeps all its digits.
  double mean(double from, double to) const { return is_constant() ? constant_ : core::mean(over_time_, from, to); }
  /// The first of the times after `time` at which it bends by more than 2 % of its range, s; infinite for none.
  double next_corner(double time) const {
    if (is_constant()) return std::numeric_limits<double>::infinity();
    const auto next = std::upper_bound(corners_.begin(), corners_.end(), time);
    return next == corners_.end() ? std::numeric_limits<double>::infinity() : *next;
  }
  /// The same, later by a time.
  TimeFunction later(double by) const {
    TimeFunction result = *this;
    for (double& x : result.over_time_.x) x += by;
    for (double& x : result.corners_) x += by;
    return result;
  }

  /// The same, at most `limit`, where it exceeds it at its given times.
  TimeFunction limited(double limit) const {
    TimeFunction result = *this;
    result.constant_ = std::min(constant_, limit);
    for (double& y : result.over_time_.y) y = std::min(y, limit);
    return result;
  }

 private:
  static constexpr double corner_share = 0.02;

  double constant_ = 0;
  Table over_time_;              ///< empty for a constant
  std::vector<double> corners_;  ///< its times at which it bends
};

}  // namespace parison::core
