#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <string>
#include <vector>

#include "forming/study/comparison/finished_run.hpp"

namespace parison::forming {

/// The order of the error bars of differences (richardson_estimate). tests/difference_bars says how well it does.
inline constexpr double difference_order = 0.7;

/// No error bar is narrower: share of a quantity's scale, as for a single run. Below it coarse runs agree on what none
/// of them resolves, such as a rim some micrometres high.
inline constexpr double least_bar = 1e-4;

/// Whether a difference is larger than its error bar.
enum class Significance { real, within_error, unknown };
/// "real", "within its error" or "no error bar".
const char* name_of(Significance significance);

/// What a difference and its error bar are, in the unit of the quantity.
struct Difference {
  std::string name, unit;
  double base, other;
  double difference;                                          ///< other - base
  double scale;                                               ///< Quantity::scale of the base
  double bar = std::numeric_limits<double>::quiet_NaN();      ///< half width; NaN where it cannot be told
  double scatter = std::numeric_limits<double>::quiet_NaN();  ///< its part by discrete decisions
  double added = std::numeric_limits<double>::quiet_NaN();    ///< the bars of both runs added, for comparison
  double model = std::numeric_limits<double>::quiet_NaN();    ///< Quantity::model of base or other, the larger
  Significance significance() const;
};

/// The wall of both over each other at the places of Quantities::profile, mm; NaN off the wall.
struct ProfileComparison {
  std::vector<double> base, other, difference, bar;
};

/// Where the error bars come from.
enum class BarSource {
  differences,  ///< the difference between the runs against that between their coarser runs
  both_bars,    ///< the bars of both runs added
  none
};
enum class ScatterSource { twins, stated };

/// What a comparison makes of runs that were made twice.
enum class Repeats {
  averaged,  ///< means of run and twin are compared, where both have one from the same stage on
  ignored    ///< the runs alone are compared; twins tell only the scatter
};

struct RunComparison {
  std::vector<Difference> quantities;
  ProfileComparison profile;
  BarSource bars = BarSource::none;
  ScatterSource scatter = ScatterSource::stated;
  std::size_t twins = 0;      ///< how many showed the scatter
  std::size_t pairs = 1;      ///< of runs of both, whose means are compared
  std::string repeated = {};  ///< what the second pair has otherwise, in words; empty without one
  std::size_t in_common = 0;  ///< stages in which both runs are the same to the last bit
};

/// Compares two runs that have completed, of the same case up to settings.
///
/// The error that both runs share cancels in their difference. What is left is taken from their coarser runs:
/// Richardson's estimate as for a single run (error_bars.hpp), made of the difference of the runs and that of their
/// coarser runs. It is at least the scatter: what two runs of the same thing differ by because remeshing and contact
/// decide otherwise, as twins show, times Student's t for as many twins and 90 %. Where both runs have a twin from the
/// same stage on, the means of run and twin are compared, whose scatter is smaller by the root of two, unless these
/// repeats are ignored.
/// `may_agree`: after how many stages they may first differ, by their cases; numbers of stages alone do not tell where
/// only heat changes.
RunComparison compare_runs(const FinishedRun& base, const FinishedRun& other,
                           std::size_t may_agree = std::numeric_limits<std::size_t>::max(),
                           Repeats repeats = Repeats::averaged);

/// Scatter of the difference of two runs, where no twin shows it, as a share of size_of_kind.
double stated_scatter(const std::string& quantity);

}  // namespace parison::forming
