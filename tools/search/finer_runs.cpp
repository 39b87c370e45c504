// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/search/finer_runs.hpp"

#include <limits>

#include "tools/search/search_runs.hpp"

namespace parison::tools {

bool run_finer(const forming::Goal& goal, forming::SearchResult& result, const std::vector<Finer>& wanted,
               const std::string& output, const std::string& folder, int jobs) {
  forming::SearchCase finer = goal;
  finer.accuracy = goal.confirm;
  std::vector<Eigen::VectorXd> places;
  for (const Finer& one : wanted) places.push_back(result.rows[one.row].at);
  forming::SweepPlan plan = forming::plan_runs(finer, places, output + '/' + folder);
  plan.sweep.error_bars = true;
  plan.sweep.keep = forming::Keep::all;
  for (std::size_t i = 0; i < wanted.size(); ++i) plan.runs[i].name = wanted[i].name;
  std::vector<forming::SweepState> states;
  std::size_t made = 0;
  if (!make_runs(plan, states, jobs, made)) return false;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    forming::Confirmed found{none, none, false, states[i].reason};
    if (states[i].status == forming::SweepState::Status::done)
      found = forming::read_confirmed(goal, plan.folder(plan.runs[i]));
    found.row = wanted[i].row;
    found.folder = folder + '/' + wanted[i].name;
    result.confirmed.push_back(std::move(found));
  }
  return true;
}

}  // namespace parison::tools
