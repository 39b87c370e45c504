#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>

#include "forming/study/uncertainty/standard_scatter.hpp"

namespace parison::forming {

/// Why the case does not take a value, empty where it does.
using Refusal = std::function<std::string(double)>;

/// The values of a tolerance that its case takes, with the sentences of those at the ends that it does not.
struct ToleranceRange {
  StandardScatter scatter;
  std::string below, above;  ///< why it ends there; empty at its natural end
};

/// Finds by bisection how far a tolerance goes before its case refuses the value; all others have their means. Throws
/// core::CaseError where it does not even take the mean.
ToleranceRange allowed_range(const core::Tolerance& tolerance, const Refusal& refusal);

/// The value that is so many standard deviations from the mean.
double value_at(const core::Tolerance& tolerance, double deviations);

}  // namespace parison::forming
