#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>

#include "forming/report/accuracy_record.hpp"
#include "forming/report/quantities.hpp"

namespace parison::forming {

/// Edges and steps of the coarse run over those of the run itself.
inline constexpr double coarsening_factor = 1.5;

/// Error estimates of a run from a coarse run: Richardson's estimate with the order that the convergence study of the
/// presets showed. Quantities of one kind lend each other the usual size of their differences, as one of them may
/// vanish by chance.
struct ErrorBars {
  Quantities quantities;             ///< those of the run, with their errors
  double profile_mean, profile_max;  ///< of the wall thickness, shares; NaN without a wall
  double heat;                       ///< into all tools, a share; NaN without
  double coarse_run_cpu_seconds = 0;
  double factor = coarsening_factor;      ///< by which the coarse run was coarser
  std::optional<AccuracyRecord> control;  ///< where an accuracy was asked for
};
/// Errors known beforehand, as shares: of the wall in the mean, of the heat into all tools; 0 where nothing is known.
struct ExpectedErrors {
  double thickness = 0, heat = 0;
};
/// No bar is narrower than its `expected` error. The coarse run is `factor` times coarser.
ErrorBars error_bars(const Quantities& run, const Quantities& coarse_run, const ExpectedErrors& expected = {},
                     double factor = coarsening_factor);

}  // namespace parison::forming
