#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "forming/study/uncertainty/effects.hpp"
#include "forming/study/uncertainty/uncertainty_plan.hpp"

namespace parison::forming {

/// A quantity with its bars: `numerical` of the mesh and the steps, twice the standard deviation from the tolerances,
/// and both as the root of the sum of their squares.
struct UncertainQuantity {
  std::string name, unit;
  double at_mean;    ///< of the run with all values at their means
  double numerical;  ///< NaN where there is no such bar
  double noise;      ///< standard deviation of runs that differ in nothing that matters
  Effects effects;
  double model = std::numeric_limits<double>::quiet_NaN();  ///< Quantity::model of that run

  double tolerance_bar() const { return 2 * deviation(effects).value; }
  double bar() const;
  std::string model_text() const;  ///< `model` for a table
};

/// Below this share of the variance at unseen runs a surrogate is called poor.
inline constexpr double good_q2 = 0.8;

/// A place of the wall.
struct UncertainPlace {
  double along;  ///< share of the profile
  double share;  ///< of the outer arc; in space of the meridian, from the axis
  double angle;  ///< of the meridian from the plane y = 0, deg; NaN where the glass stays round
  UncertainQuantity thickness;
};

/// What the runs of a study say.
struct UncertaintyResult {
  std::vector<UncertainQuantity> quantities;
  std::vector<UncertainPlace> wall;  ///< empty without one
  std::optional<Effects> wall_effects;
  std::size_t done = 0, failed = 0, waiting = 0;
  std::vector<std::string> failures;  ///< of drawn runs, "run_0007: why"
  std::vector<std::string> left_out;  ///< quantities that too few runs have
};

/// Reads the runs of a study and takes the scatter of each quantity apart. Throws core::CaseError where the run at the
/// means has failed or too few of the drawn ones have come to their end.
UncertaintyResult analyse_uncertainty(const UncertaintyPlan& plan);

/// Tolerances in the order in which they should be measured: by their total indices of the wall, of the mean over the
/// quantities without a wall. With the indices.
struct Ranking {
  std::vector<std::size_t> order;
  SobolIndices indices;
  std::string of;  ///< what scatters
};
Ranking measure_first(const UncertaintyPlan& plan, const UncertaintyResult& result);

/// Writes uncertainty.json, uncertainty.csv, sobol_indices.csv, wall.csv and uncertainty.svg into the folder.
void write_uncertainty(const UncertaintyPlan& plan, const UncertaintyResult& result);

/// The picture: what to measure first, the indices of all quantities, the wall with its bars.
std::string uncertainty_picture(const UncertaintyPlan& plan, const UncertaintyResult& result);

}  // namespace parison::forming
