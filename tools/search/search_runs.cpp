// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/search/search_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <thread>
#include <utility>

#include "tools/program/bundled_cases.hpp"
#include "tools/sweep/run_pool.hpp"

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

using Status = forming::SweepState::Status;

SearchRuns::SearchRuns(const forming::SearchCase& search, std::string output, int jobs)
    : search_(search),
      base_(forming::read_scene(search.case_path, search.accuracy, search.overrides)),
      shared_(forming::shared_stage(search)),
      output_(std::move(output)),
      jobs_(jobs) {}

std::vector<MadeRun> SearchRuns::make(const std::vector<Eigen::VectorXd>& places) {
  std::vector<MadeRun> runs;
  std::vector<Eigen::VectorXd> taken;
  for (const Eigen::VectorXd& at : places) {
    runs.push_back({"", forming::refusal_of(search_, base_, at)});
    if (runs.back().reason.empty()) taken.push_back(at);
  }
  const std::string name = fmt::format("step_{:03}", ++step_);
  if (taken.empty()) return runs;
  forming::SweepPlan plan = forming::plan_runs(search_, taken, output_ + '/' + name);
  if (shared_ && !first_) first_ = forming::FirstRun{plan.folder(plan.runs.front()), *shared_};
  plan.first = first_;
  std::vector<forming::SweepState> states;
  if (!make_runs(plan, states, jobs_, made_)) return {};
  std::size_t next = 0;
  for (MadeRun& run : runs) {
    if (!run.reason.empty()) continue;
    run = {name + '/' + plan.runs[next].name, states[next].reason};
    if (run.reason.empty() && states[next].status == Status::failed) run.reason = "it failed";
    ++next;
  }
  return runs;
}

bool make_runs(const forming::SweepPlan& plan, std::vector<forming::SweepState>& states, int jobs, std::size_t& made) {
  forming::claim_sweep(plan);
  forming::write_manifest(plan);
  states.clear();
  for (const forming::SweepRun& run : plan.runs) states.push_back(forming::state_of(plan, run));
  const auto waiting = std::count_if(states.begin(), states.end(),
                                     [](const forming::SweepState& state) { return state.status == Status::waiting; });
  if (waiting == 0) return true;
  made += static_cast<std::size_t>(waiting);
  return run_sweep(plan, states, jobs, Report::none);
}

int usual_jobs(int asked) {
  return asked > 0 ? asked : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace parison::tools
