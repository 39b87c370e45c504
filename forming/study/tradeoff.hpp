#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/report/quantities.hpp"
#include "forming/scene/calibration.hpp"
#include "forming/study/convergence_study.hpp"

namespace parison::forming {

/// A variant that has run, and the variant that it is compared with.
struct VariantResult {
  Variant variant;
  bool completed = false;
  std::string reason;
  double cpu = 0;  ///< s
  long steps = 0;
  double reynolds = 0;
  Quantities quantities;
  ProfileDifference profile{};  ///< to the reference, of a model variant to the base
  double heat = 0;              ///< likewise, a share
  bool on_front = false;

  /// The larger one of the mean thickness error and that of the heat; NaN where the scene has neither.
  double error() const;
};

/// Fills in the differences; the first result is the reference, `base` names the base variant.
void compare_variants(std::vector<VariantResult>& results, const std::string& base);

/// Marks the variants no other is both faster and closer than; reference and model variants take no part.
void mark_front(std::vector<VariantResult>& results);

/// CPU time of a variant over that of the best line at the same error; the line runs straight in the logarithms between
/// the variants on the front. NaN off the line's ends.
double over_front(const std::vector<VariantResult>& results, const VariantResult& variant);

/// The accuracy level's measured errors E as a law A*(2^(-p level) - 2^(-p reference)), the reference's own error taken
/// off; at_draft is NaN where fewer than two variants of the accuracy level tell.
ErrorLaw fit_error_law(const std::vector<VariantResult>& results, double (*error)(const VariantResult&));

}  // namespace parison::forming
