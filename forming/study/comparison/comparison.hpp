#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "forming/run/resume/case_differences.hpp"
#include "forming/study/comparison/difference.hpp"

namespace parison::forming {

/// A run beside the base.
struct ComparedRun {
  std::string label;
  std::vector<CaseDifference> settings;  ///< in which it differs from the base
  std::string reason;                    ///< why it has no results; empty with them
  std::optional<RunComparison> result;
  FinishedRun run = {};
  bool unchanged = false;  ///< it has the values of the base, and was not run
};

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
