#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

namespace parison::core {

struct CaseFile;

/// How the values of a toleranced quantity scatter.
enum class Distribution { normal, uniform };

/// A quantity with its tolerance, "460 +- 10 degC".
struct Tolerance {
  std::string key;    ///< of the quantity, as --set takes it
  std::string given;  ///< the text as it stands in the case
  double mean = 0;    ///< in `unit`
  double spread = 0;  ///< standard deviation of normal, half the width of uniform scatter, in `unit`
  std::string unit;   ///< of the mean; empty for plain numbers
  Distribution distribution = Distribution::normal;

  /// The standard deviation, in `unit`.
  double deviation() const;
  /// A value as the case would give it, "471.5 degC".
  std::string value_text(double value) const;
};

/// Takes the tolerances out of a case: each text "460 +- 10 degC" becomes "460 degC". Refuses a tolerance that is
/// not above zero or of another dimension than its mean.
std::vector<Tolerance> take_tolerances(CaseFile& file);

/// Where "+-" or its sign stands in a text, npos without one.
std::size_t find_tolerance(const std::string& text);

}  // namespace parison::core
