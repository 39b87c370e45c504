// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/uncertainty/tolerance_range.hpp"

#include "core/case/case_error.hpp"

namespace parison::forming {
namespace {

/// The last value between the mean and an end that is taken, and why the next one is not.
double find_end(const core::Tolerance& tolerance, double end, const Refusal& refusal, std::string& reason) {
  constexpr int halvings = 16;
  reason = refusal(value_at(tolerance, end));
  if (reason.empty()) return end;
  double taken = 0, refused = end;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (taken + refused);
    const std::string found = refusal(value_at(tolerance, middle));
    if (!found.empty()) reason = found;
    (found.empty() ? taken : refused) = middle;
  }
  return taken;
}

}  // namespace

double value_at(const core::Tolerance& tolerance, double deviations) {
  return tolerance.mean + deviations * tolerance.deviation();
}

ToleranceRange allowed_range(const core::Tolerance& tolerance, const Refusal& refusal) {
  if (const std::string reason = refusal(tolerance.mean); !reason.empty()) throw core::CaseError(reason);
  ToleranceRange range{full_range(tolerance.distribution), "", ""};
  range.scatter.low = find_end(tolerance, range.scatter.low, refusal, range.below);
  range.scatter.high = find_end(tolerance, range.scatter.high, refusal, range.above);
  return range;
}

}  // namespace parison::forming
