#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>
#include <vector>

#include "forming/study/search/case/search_case.hpp"
#include "forming/study/search/search_result.hpp"

namespace parison::tools {

/// A row of a search that is to be run at the accuracy of `confirm`, and the name of its folder.
struct Finer {
  std::string name;
  std::size_t row;
};

/// Runs rows with error bars in a folder of the search's output and adds them to those that are confirmed; false where
/// stopped.
bool run_finer(const forming::Goal& goal, forming::SearchResult& result, const std::vector<Finer>& wanted,
               const std::string& output, const std::string& folder, int jobs);

/// A run that was asked for.
struct MadeRun {
  std::string folder;  ///< empty where the case refuses the values
  std::string reason;  ///< why it has no results; empty with them
};

/// Makes the runs of a search, those of one step at once, each step in a folder of its own. The steps of a search
/// follow from the results before them, so that the same search in the same folder finds its runs made. Stages that no
/// variable changes are made by the first run alone.
class SearchRuns {
 public:
  SearchRuns(const forming::SearchCase& search, std::string output, int jobs);

  /// Fewer runs than places where stopped on request.
  std::vector<MadeRun> make(const std::vector<Eigen::VectorXd>& places);
  std::size_t made() const { return made_; }  ///< by this call of the program

 private:
  const forming::SearchCase& search_;
  const forming::Scene base_;
  const std::optional<std::string> shared_;
  std::optional<forming::FirstRun> first_ = {};
  std::string output_;
  int jobs_, step_ = 0;
  std::size_t made_ = 0;
};

/// Makes the runs of a plan that are not there, without a line on each; false where stopped. `made` counts them.
bool make_runs(const forming::SweepPlan& plan, std::vector<forming::SweepState>& states, int jobs, std::size_t& made);

/// As many as there are cores where none are asked for.
int usual_jobs(int asked);

}  // namespace parison::tools
