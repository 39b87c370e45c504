#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "core/case/table.hpp"

namespace parison::core {

/// A quantity over time, s: a constant, or piecewise linear between given times and constant before the first and after
/// the last of them.
class TimeFunction {
 public:
  TimeFunction(double constant = 0) : constant_(constant) {}
  explicit TimeFunction(Table over_time) : over_time_(std::move(over_time)) {}

  double operator()(double time) const { return is_constant() ? constant_ : over_time_(time); }
  /// Rate of change per second; at one of the given times that of the interval after it.
  double derivative(double time) const { return is_constant() ? 0 : over_time_.derivative(time); }
  double min() const { return is_constant() ? constant_ : *std::min_element(over_time_.y.begin(), over_time_.y.end()); }
  double max() const { return is_constant() ? constant_ : *std::max_element(over_time_.y.begin(), over_time_.y.end()); }

  /// The same, at most `limit`, where it exceeds it at its given times.
  TimeFunction limited(double limit) const {
    TimeFunction result = *this;
    result.constant_ = std::min(constant_, limit);
    for (double& y : result.over_time_.y) y = std::min(y, limit);
    return result;
  }

 private:
  bool is_constant() const { return over_time_.x.empty(); }

  double constant_ = 0;
  Table over_time_;  ///< empty for a constant
};

}  // namespace parison::core
