#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "forming/report/quantities.hpp"

namespace parison::forming {

/// Edges and steps of the coarser runs over those of the run itself.
inline constexpr std::array coarser_factors{1.5, 3.0};

/// The order of the error bars. Chosen on the scenes of tests/bars, which say how well it does on each of them left
/// out. It is below the order of the method, because runs agree by chance and because contact comes in jumps.
inline constexpr double bar_order = 0.65;

/// How much wider a bar is that rests on one coarser run: with two, a second difference shows where the first is small
/// by chance. It is that of the grid convergence index, whose factor of safety is 3 with two grids and 1.25 with three
/// (P. J. Roache, J. Fluids Eng. 116 (1994) 405-413; Annu. Rev. Fluid Mech. 29 (1997) 123-160).
inline constexpr double single_run_factor = 3 / 1.25;

/// A run of the same scene with edges and steps `factor` times as long.
struct CoarserRun {
  double factor;
  Quantities quantities;
  double cpu_seconds = 0;
};

/// One of the runs that were made to reach an accuracy.
struct ControlledRun {
  double factor;           ///< edges and steps, in units of those of the draft preset
  double cpu_seconds = 0;  ///< of the run
  bool completed = true;   ///< whether it came to its end
  double estimate = std::numeric_limits<double>::infinity();  ///< error of this run, a share
  std::vector<std::string> condemned_by = {};  ///< checks, with value and limit, that speak against the estimate
};

/// How an accuracy that was asked for was reached, or was not.
struct AccuracyRecord {
  double target;  ///< share of the wall in the mean and of the heat into the tools
  std::vector<ControlledRun> runs;
  std::vector<std::string> not_mended = {};  ///< checks that speak against the last run and that finer ones do not mend
  bool reached() const { return !runs.empty() && runs.back().estimate <= target && runs.back().condemned_by.empty(); }
};

/// Error estimates of a run from coarser runs of the same scene, and from nothing else.
struct ErrorBars {
  Quantities quantities;             ///< those of the run, with their errors; without one where no coarser run has them
  double profile_mean, profile_max;  ///< of the wall thickness, shares; NaN without a wall
  double heat;                       ///< into all tools, a share; NaN without
  std::vector<CoarserRun> coarser;
  std::optional<AccuracyRecord> control;  ///< where an accuracy was asked for
};

/// The bar of a quantity: that of its values in all runs (bar_of_values). Temperatures and heats lend each other the
/// usual size of their bars.
ErrorBars error_bars(const Quantities& run, std::vector<CoarserRun> coarser);

/// Richardson's estimate of the error of a run by the difference of two runs whose edges and steps are `fine` and
/// `coarse` times as long as its own (L. F. Richardson, Phil. Trans. R. Soc. A 210 (1911) 307-357).
double richardson_estimate(double difference, double fine, double coarse, double order = bar_order);

/// A value, and how many times as long as those of the run in question are edges and steps of the run that gave it.
struct ValueOfRun {
  double factor, value;
};

/// The error bar of the first value by those of ever coarser runs of the same scene: the largest estimate that its
/// differences from them make and, where the values do not go one way with the edges, those of the coarser runs beside
/// the turn: there the first may agree with the next by chance. Where only one other is finite, single_run_factor times
/// its estimate. NaN where the first or all others are not finite.
double bar_of_values(const std::vector<ValueOfRun>& values);

/// The bars of a kind are alike as shares of this. Heats: between its own, of which the mesh and the steps get a
/// share wrong, and all of it, as what one tool gets too much another lacks. In the unit of the quantity.
double size_of_kind(const Quantities& run, const Quantity& quantity);

}  // namespace parison::forming
