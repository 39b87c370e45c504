// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/search/optimise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "forming/study/search/goal_file.hpp"
#include "forming/study/search/minimum/least_squares.hpp"
#include "forming/study/search/minimum/scalar_search.hpp"
#include "forming/study/search/search_result.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/folder_lock.hpp"
#include "tools/program/stop_request.hpp"
#include "tools/report/report.hpp"
#include "tools/search/search_runs.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using Eigen::VectorXd;
using forming::Goal;
using forming::SearchResult;
using forming::SearchRow;
using forming::Worth;

/// A search while it goes on: each run is a row and a line.
struct Course {
  const Goal& goal;
  const std::string& output;
  SearchRuns runs;
  SearchResult result = {};
  bool stopped = false;
};

std::string row_line(const Goal& goal, const SearchRow& row) {
  std::string line = row.worth ? fmt::format("{:>9.4g}{}", row.worth->value, row.worth->holds() ? "  " : " !")
                               : std::string("   failed  ");
  for (std::size_t i = 0; i < goal.variables.size(); ++i)
    line += fmt::format("  {:.4g}", goal.variables[i].value(row.at[Eigen::Index(i)]));
  return row.worth ? line : line + "  " + row.outcome.reason;
}

void add_row(Course& course, const VectorXd& at, const MadeRun& run) {
  SearchRow row{at, run.folder, {run.reason, {}, {}}, std::nullopt};
  if (run.reason.empty()) {
    row.outcome = forming::read_outcome(course.output + '/' + run.folder, course.goal.target.part);
    row.worth = forming::worth(course.goal, row.outcome);
    if (!row.worth && row.outcome.reason.empty()) row.outcome.reason = "it lacks what the goal needs";
  }
  fmt::print("[{:>{}}/{}] {}\n", course.result.rows.size() + 1, fmt::formatted_size("{}", course.goal.runs),
             course.goal.runs, row_line(course.goal, row));
  std::fflush(stdout);
  course.result.rows.push_back(std::move(row));
}

/// The worth of places, nothing where a run failed; fewer where stopped.
std::vector<std::optional<Worth>> ask(Course& course, const std::vector<VectorXd>& places) {
  const std::vector<MadeRun> made = course.runs.make(places);
  std::vector<std::optional<Worth>> found;
  for (std::size_t i = 0; i < made.size(); ++i) {
    add_row(course, places[i], made[i]);
    found.push_back(course.result.rows.back().worth);
  }
  course.stopped = course.stopped || made.size() < places.size();
  return found;
}

struct Box {
  VectorXd start, low, high, step;
};

Box box_of(const Goal& goal) {
  const auto count = static_cast<Eigen::Index>(goal.variables.size());
  Box box{VectorXd(count), VectorXd(count), VectorXd(count), VectorXd(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const forming::SearchVariable& variable = goal.variables[std::size_t(i)];
    box.start[i] = variable.start;
    box.low[i] = variable.low();
    box.high[i] = variable.high();
    box.step[i] = variable.step;
  }
  return box;
}

std::string search_by_least_squares(Course& course) {
  using Ending = forming::LeastSquaresResult::Ending;
  const Box box = box_of(course.goal);
  const auto found =
      forming::least_squares(box.start,
                             {box.low, box.high, box.step, course.goal.runs, Eigen::Index(course.goal.limits.size()),
                              forming::good_norm(course.goal)},
                             [&](const std::vector<VectorXd>& places) {
                               std::vector<std::optional<VectorXd>> residuals;
                               for (const auto& worth : ask(course, places))
                                 residuals.push_back(worth ? std::optional(worth->residual) : std::nullopt);
                               return residuals;
                             });
  switch (found.ending) {
    case Ending::good_enough:
      return "the goal is good enough";
    case Ending::no_more_gain:
      return "no step makes it better by more than the noise of the runs";
    case Ending::no_more_runs:
      return "the runs are used up";
    case Ending::start_failed:
      return "the run at the start has no results to go on from";
    case Ending::stopped:
      break;
  }
  return "stopped on request";
}

std::string search_scalar(Course& course) {
  const Box box = box_of(course.goal);
  constexpr double none = -std::numeric_limits<double>::infinity();
  const auto ending = forming::scalar_search(
      box.start,
      {box.low, box.high, box.step, course.goal.runs, course.goal.limits.size(),
       forming::good_value(course.goal).value_or(none)},
      [&](const VectorXd& at) -> std::optional<forming::ScalarValue> {
        const auto found = ask(course, {at});
        if (found.empty() || !found.front()) return std::nullopt;
        return forming::ScalarValue{found.front()->value, found.front()->excess};
      },
      [&] { return course.stopped; });
  if (ending == forming::ScalarEnding::good_enough) return "the goal is good enough";
  if (ending == forming::ScalarEnding::no_more_runs) return "the runs are used up";
  return ending == forming::ScalarEnding::stopped ? "stopped on request"
                                                  : "the steps have become as small as the noise of the runs";
}

/// Runs the start and the answer with error bars at the accuracy of the answer; false where stopped.
bool confirm(Course& course, int jobs) {
  const Goal& goal = course.goal;
  SearchResult& result = course.result;
  if (goal.confirm.empty() || !result.rows[result.best].worth) return true;
  forming::SearchCase finer = goal;
  finer.accuracy = goal.confirm;
  std::vector<VectorXd> places{result.rows.front().at};
  if (result.best != 0) places.push_back(result.rows[result.best].at);
  forming::SweepPlan plan = forming::plan_runs(finer, places, course.output + "/confirmed");
  plan.sweep.error_bars = true;
  plan.sweep.keep = forming::Keep::all;
  plan.runs.front().name = "start";
  if (places.size() > 1) plan.runs.back().name = "answer";
  fmt::print("the start and the answer at {} accuracy with error bars\n", goal.confirm);
  std::fflush(stdout);
  std::vector<forming::SweepState> states;
  std::size_t made = 0;
  if (!make_runs(plan, states, jobs, made)) return false;
  const auto read = [&](std::size_t i) {
    if (states[i].status == forming::SweepState::Status::done)
      return forming::read_confirmed(goal, plan.folder(plan.runs[i]));
    const double none = std::numeric_limits<double>::quiet_NaN();
    return forming::Confirmed{none, none, false, states[i].reason};
  };
  result.start = read(0);
  result.answer = read(places.size() - 1);
  std::vector<std::string> folders;
  for (const forming::SweepRun& run : plan.runs)
    if (fs::exists(plan.folder(run) + "/glass.pvd")) folders.push_back(plan.folder(run));
  if (!folders.empty()) report({folders, course.output + "/report.html", forming::course_text(goal, result)});
  return true;
}

std::string confirmed_text(const std::optional<forming::Confirmed>& confirmed) {
  if (!confirmed) return "";
  if (!confirmed->reason.empty()) return "  no results: " + confirmed->reason;
  return std::isfinite(confirmed->bar) ? fmt::format("{:>11.4g} +- {:.2g}", confirmed->value, confirmed->bar)
                                       : fmt::format("{:>11.4g}", confirmed->value);
}

/// The start beside the answer: goal, limits, variables.
void print_answer(const Goal& goal, const SearchResult& result) {
  const SearchRow &start = result.rows.front(), &best = result.rows[result.best];
  const auto value = [](const SearchRow& row) { return row.worth ? row.worth->value : std::nan(""); };
  fmt::print("\n  {:<40}{:>12}{:>12}\n", "", "start", "answer");
  fmt::print("  {:<40}{:>12.4g}{:>12.4g}\n", forming::what_is_sought(goal), value(start), value(best));
  for (const forming::Limit& limit : goal.limits) {
    const auto at = [&](const SearchRow& row) {
      const forming::Quantity* found = row.outcome.quantities.find(limit.quantity);
      return found ? found->value : std::nan("");
    };
    fmt::print(
        "  {:<40}{:>12.4g}{:>12.4g}{}\n",
        fmt::format("{} {} {:g} {}", limit.quantity, limit.at_least ? "at least" : "at most", limit.value, limit.unit),
        at(start), at(best), limit.at_least == (at(best) >= limit.value) || at(best) == limit.value ? "" : "  missed");
  }
  for (std::size_t i = 0; i < goal.variables.size(); ++i) {
    const forming::SearchVariable& variable = goal.variables[i];
    const auto at = [&](const SearchRow& row) { return variable.value(row.at[Eigen::Index(i)]); };
    const double place = best.at[Eigen::Index(i)], near = 1e-6 * (variable.high() - variable.low());
    const bool held = place <= variable.low() + near || place >= variable.high() - near;
    fmt::print("  {:<40}{:>12.5g}{:>12.5g} {}{}\n", variable.key, at(start), at(best), variable.bounds.unit,
               held ? "  at its bound" : "");
  }
  if (result.answer)
    fmt::print("  at {} accuracy: start {}, answer {}\n", goal.confirm, confirmed_text(result.start),
               confirmed_text(result.answer));
}

int close_search(const Goal& goal, Course& course) {
  SearchResult& result = course.result;
  const std::vector<std::string> written = forming::write_search(goal, result, course.output);
  const SearchRow& best = result.rows[result.best];
  if (best.worth) print_answer(goal, result);
  const auto failed =
      std::count_if(result.rows.begin(), result.rows.end(), [](const SearchRow& row) { return !row.worth; });
  fmt::print("\n  {} runs, {} failed: {}; {}/{}\n", result.rows.size(), failed, result.ending, course.output,
             fmt::join(written, ", "));
  if (!best.worth) {
    fmt::print(stderr, "parison: no run has what the goal needs, the first because: {}\n",
               result.rows.front().outcome.reason);
    return run_failed;
  }
  if (!best.worth->holds()) {
    fmt::print(stderr, "parison: no run that was made holds all limits; the answer misses them least\n");
    return run_failed;
  }
  if (const auto good = forming::good_value(goal); good && best.worth->value > *good) {
    const double sign = goal.target.kind == forming::Target::Kind::most ? -1 : 1;
    fmt::print(stderr, "parison: no run that was made reaches {:g}; the answer is the nearest, {:.4g}\n", sign * *good,
               sign * best.worth->value);
    return run_failed;
  }
  return 0;
}

void print_opening(const Goal& goal, const std::string& output, int jobs) {
  fmt::print("{} at {} accuracy: {} to vary, up to {} runs, {} at once, in {}\n", goal.case_path, goal.accuracy,
             goal.variables.size(), goal.runs, jobs, output);
  fmt::print("  sought: {} (! misses a limit), then", forming::what_is_sought(goal));
  for (const forming::SearchVariable& variable : goal.variables)
    fmt::print(" {}{}", variable.key, variable.bounds.unit.empty() ? "" : " in " + variable.bounds.unit);
  fmt::print("\n");
  std::fflush(stdout);
}

}  // namespace

int optimise(const OptimiseRequest& request) {
  const Goal goal = forming::read_goal(request.file, case_named);
  forming::check_corners(goal);
  const std::string output = request.output.empty() ? "results/optimise_" + goal.name : request.output;
  const int jobs = usual_jobs(request.jobs);
  print_opening(goal, output, jobs);
  if (request.check) return 0;
  catch_signals();
  fs::create_directories(output);
  const FolderLock lock(output);
  Course course{goal, output, SearchRuns(goal, output, jobs)};
  course.result.ending = goal.target.is_scalar() ? search_scalar(course) : search_by_least_squares(course);
  if (!course.stopped) {
    course.result.best = forming::best_row(course.result.rows);
    course.stopped = !confirm(course, jobs);
  }
  if (!course.stopped) return close_search(goal, course);
  fmt::print(stderr, "parison: stopped on request; the same command goes on with it\n");
  return run_failed;
}

}  // namespace parison::tools
