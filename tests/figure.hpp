#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace parison::tests {

/// A figure of the verification table in tests/README.md: of several values the worst counts. Its bound is asserted,
/// and recorded with the running test in the report that tools/verification_table reads.
class Figure {
 public:
  /// `what` is measured, in `unit`, empty for a ratio or an order.
  explicit Figure(std::string what, std::string unit = "") : what_(std::move(what)), unit_(std::move(unit)) {}

  void add(double value) {
    is_number_ = is_number_ && !std::isnan(value);
    min_ = std::min(min_, value);
    max_ = std::max(max_, value);
  }
  /// Asserts that no value is above the bound, and none is missing.
  void at_most(double bound) const {
    EXPECT_LE(worst(max_), bound) << what_;
    record(worst(max_), "at most", fmt::format("{}", bound));
  }
  /// Asserts that no value is below the bound, and none is missing.
  void at_least(double bound) const {
    EXPECT_GE(worst(min_), bound) << what_;
    record(worst(min_), "at least", fmt::format("{}", bound));
  }
  /// Records the largest value for comparison; nothing is required of it.
  void for_comparison() const { record(worst(max_), "", "null"); }

 private:
  double worst(double value) const {
    return is_number_ && min_ <= max_ ? value : std::numeric_limits<double>::quiet_NaN();
  }
  void record(double measured, const char* sense, const std::string& bound) const {
    static int count = 0;  // the names of a test's properties differ
    testing::Test::RecordProperty(
        fmt::format("figure_{}", ++count),
        fmt::format(R"({{"what": "{}", "unit": "{}", "measured": {}, "sense": "{}", "bound": {}}})", what_, unit_,
                    std::isfinite(measured) ? fmt::format("{:.6g}", measured) : "null", sense, bound));
  }

  std::string what_, unit_;
  bool is_number_ = true;
  double min_ = std::numeric_limits<double>::infinity(), max_ = -min_;
};

inline void expect_at_most(const std::string& what, double measured, double bound, const std::string& unit = "") {
  Figure figure(what, unit);
  figure.add(measured);
  figure.at_most(bound);
}
inline void expect_at_least(const std::string& what, double measured, double bound, const std::string& unit = "") {
  Figure figure(what, unit);
  figure.add(measured);
  figure.at_least(bound);
}

}  // namespace parison::tests
