#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "forming/run/resume/case_differences.hpp"
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

/// A run beside the base.
struct ComparedRun {
  std::string label;
  std::vector<CaseDifference> settings;  ///< in which it differs from the base
  std::string reason;                    ///< why it has no results; empty with them
  std::optional<RunComparison> result;
  FinishedRun run = {};
  bool unchanged = false;  ///< it has the values of the base, and was not run
};

/// The row of a quantity; null where it has none.
const Difference* find_row(const ComparedRun& other, const std::string& quantity);

struct Comparison {
  FinishedRun base;
  std::vector<ComparedRun> others;
};

/// Compares result folders; throws core::CaseError where the base has not come to its end, a folder is none of a run
/// that has ended, or is of another case. Another run that stopped on its way is kept with its reason.
Comparison compare_folders(const std::string& base, const std::vector<std::string>& others,
                           Repeats repeats = Repeats::averaged);

/// Refuses a run that stopped as the base, with its reason.
std::string no_base(const std::string& folder, const std::string& reason);

/// A row of a table of differences, as people read it: so many digits that the bar shows two.
struct ShownDifference {
  std::string label, base, other, difference, bar, model, unit, verdict;
};
ShownDifference shown(const Difference& row);

/// Where the bars of a comparison come from, or why there are none, as lines.
std::string bars_line(const RunComparison& result, const FinishedRun& base, const FinishedRun& other);

/// Which models both runs used, and which differences are smaller than what the best ones were found to move; where the
/// runs have other models, that they differ. As lines; empty where both have the best.
std::string models_line(const RunComparison& result, const FinishedRun& base, const FinishedRun& other);

/// Throws core::CaseError where a quantity that was named by --quantity is none of the known ones, with their names.
void require_quantity(const std::string& quantity, const std::vector<Quantity>& known);

/// The tables for the terminal: of each run all quantities, below them remark_lines; then of each run what it does to
/// the thinnest wall, or to the quantity that is named.
std::string comparison_tables(const Comparison& comparison);
std::string ranking_table(const Comparison& comparison, const std::string& quantity);
/// The flags, warnings and failed checks of base and other runs, under the runs that have them: all, one or some.
std::string remark_lines(const Comparison& comparison);
/// The quantity of that table where none is named: the thinnest wall, else the first quantity.
std::string ranked_quantity(const Comparison& comparison);

/// The names of the files of a comparison.
std::set<std::string> comparison_files();

/// Writes comparison.csv, comparison.json, profiles.csv and profiles.svg, the last two where the walls of base and
/// another run are compared; where they are not, those of an earlier comparison in the folder go. Returns which, and
/// where, in words.
std::string write_comparison(const Comparison& comparison, const std::string& folder);

/// The walls over each other and their differences from the base with error bars, as SVG; empty without a wall.
std::string profile_plot(const Comparison& comparison);

}  // namespace parison::forming
