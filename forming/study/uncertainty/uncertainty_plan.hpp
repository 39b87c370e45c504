#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "forming/study/sweep/sweep_plan.hpp"
#include "forming/study/uncertainty/effects.hpp"

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

/// What is asked of a study of tolerances.
struct UncertaintyStudy {
  std::string case_path, accuracy;
  std::vector<std::string> overrides;
  std::string output;
  std::size_t runs = 0;  ///< with values drawn from the tolerances; 0: `usual_runs`
  std::uint64_t seed = 0;
};

/// Eight a tolerance, 32 at least.
std::size_t usual_runs(std::size_t tolerances);

/// Values that were drawn and that the case refuses together.
struct RefusedRow {
  std::vector<std::string> values;
  std::string reason;
};

/// The runs of such a study: the case at its means with its error bars, the same with changes that mean nothing, which
/// show the noise, and those with values drawn from the tolerances (Sobol sequence).
struct UncertaintyPlan {
  UncertaintyStudy study;
  std::vector<core::Tolerance> tolerances;
  std::vector<ToleranceRange> ranges;
  SweepPlan mean, noise, drawn;
  Eigen::MatrixXd places;  ///< a row a drawn run, a column a tolerance, in standard deviations from the mean
  std::vector<RefusedRow> refused;
  std::optional<double> sector;  ///< of glass in space, rad
};

/// Throws core::CaseError where the case has no tolerance, where it has too few runs for its tolerances, or where half
/// of what is drawn is refused.
UncertaintyPlan plan_uncertainty(const UncertaintyStudy& study);

}  // namespace parison::forming
