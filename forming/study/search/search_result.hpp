#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/study/search/goal.hpp"

namespace parison::forming {

/// A run of a search.
struct SearchRow {
  Eigen::VectorXd at;
  std::string folder;           ///< empty where the case refused the values
  Outcome outcome;              ///< as it was run
  std::optional<Worth> worth;   ///< of that
  std::size_t corrections = 0;  ///< that had been made when it was asked for
  /// With the difference of the finer accuracy added, and the worth of that; nothing before the first correction.
  std::optional<Outcome> corrected = {};
  std::optional<Worth> corrected_worth = {};

  /// What the search goes by.
  const Outcome& counted_outcome() const { return corrected ? *corrected : outcome; }
  const std::optional<Worth>& counted_worth() const { return corrected ? corrected_worth : worth; }
};

/// A run of the start or of an answer with error bars, from its coarser runs.
struct Confirmed {
  double value, bar;   ///< of the goal; the bar is not a number where no coarser run has it
  bool holds;          ///< all limits
  std::string reason;  ///< why there is none
  Outcome outcome = {};
  std::optional<Worth> worth = {};
  std::size_t row = 0;      ///< that was run
  std::string folder = {};  ///< in that of the search
};

/// All that a search has found.
struct SearchResult {
  std::vector<SearchRow> rows;  ///< the first is the start
  std::size_t best = 0;
  std::string ending;                     ///< a sentence, of the last search
  std::vector<Confirmed> confirmed = {};  ///< the start, then each answer that is not one of those before
  std::size_t corrections = 0;

  const Confirmed* confirmed_of(std::size_t row) const;  ///< null where it was not confirmed
};

/// The row that counts most; the first where none is worth anything.
std::size_t best_row(const std::vector<SearchRow>& rows);

/// The confirmed row that is worth most at the finer accuracy; the best row where none is worth anything there.
std::size_t best_confirmed_row(const SearchResult& result);

/// What the answer is judged by: after a correction the run at the finer accuracy, where it has results.
const std::optional<Worth>& worth_of_answer(const SearchResult& result);

/// Reads a run at the finer accuracy with its coarser ones.
Confirmed read_confirmed(const Goal& goal, const std::string& folder);

/// The goal, whether the limits hold and the best so far over the runs, and where each variable was between its bounds
/// (0 to 1), as JSON for a plot; null where a run has no results.
std::string course_text(const Goal& goal, const SearchResult& result);

/// Writes runs.csv, result.json, wall.csv, the case with the values of the best run in the folder `case`, and NAME.dxf
/// of each tool that they give another outline. Returns the names of what it wrote.
std::vector<std::string> write_search(const Goal& goal, const SearchResult& result, const std::string& output);

}  // namespace parison::forming
