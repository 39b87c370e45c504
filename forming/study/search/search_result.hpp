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
  std::string folder;  ///< empty where the case refused the values
  Outcome outcome;
  std::optional<Worth> worth;
};

/// A run of the start or of the answer with error bars, from its coarser runs.
struct Confirmed {
  double value, bar;   ///< of the goal; the bar is not a number where no coarser run has it
  bool holds;          ///< all limits
  std::string reason;  ///< why there is none
};

/// All that a search has found.
struct SearchResult {
  std::vector<SearchRow> rows;  ///< the first is the start
  std::size_t best = 0;
  std::string ending;  ///< a sentence
  std::optional<Confirmed> start, answer;
};

/// The row that is worth most; the first where none is worth anything.
std::size_t best_row(const std::vector<SearchRow>& rows);

/// Reads a run with its coarser ones.
Confirmed read_confirmed(const Goal& goal, const std::string& folder);

/// The goal, whether the limits hold and the best so far over the runs, and where each variable was between its bounds
/// (0 to 1), as JSON for a plot; null where a run has no results.
std::string course_text(const Goal& goal, const SearchResult& result);

/// Writes runs.csv, result.json, wall.csv, the case with the values of the best run in the folder `case`, and NAME.dxf
/// of each tool that they give another outline. Returns the names of what it wrote.
std::vector<std::string> write_search(const Goal& goal, const SearchResult& result, const std::string& output);

}  // namespace parison::forming
