// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/search/optimise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/io/written_files.hpp"
#include "forming/study/search/goal.hpp"
#include "forming/study/search/minimum/least_squares.hpp"
#include "forming/study/search/minimum/scalar_search.hpp"
#include "forming/study/search/search_result.hpp"
#include "tools/program/bundled_cases.hpp"
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
  forming::Correction correction = {};  ///< after the first
};

std::string row_line(const Goal& goal, const SearchRow& row) {
  const auto& worth = row.counted_worth();
  std::string line =
      worth ? fmt::format("{:>9.4g}{}", worth->value, worth->holds() ? "  " : " !") : std::string("   failed  ");
  for (std::size_t i = 0; i < goal.variables.size(); ++i)
    line += fmt::format("  {:.4g}", goal.variables[i].value(row.at[Eigen::Index(i)]));
  if (!worth) return line + "  " + row.outcome.reason;
  return row.corrected ? line + fmt::format("  corrected, {:.4g} at {}", row.worth->value, goal.accuracy) : line;
}

/// The worth of a run with the difference of the two accuracies added.
void count_corrected(const Course& course, SearchRow& row) {
  if (!row.worth) return;
  row.corrected = forming::corrected(row.outcome, course.correction, course.goal.target.part);
  row.corrected_worth = forming::worth(course.goal, *row.corrected);
}

void add_row(Course& course, const VectorXd& at, const MadeRun& run) {
  SearchRow row{at, run.folder, {run.reason, {}, {}}, std::nullopt};
  if (run.reason.empty()) {
    row.outcome = forming::read_outcome(course.output + '/' + run.folder, course.goal.target.part);
    row.worth = forming::worth(course.goal, row.outcome);
    if (!row.worth && row.outcome.reason.empty()) row.outcome.reason = "it lacks what the goal needs";
  }
  row.corrections = course.result.corrections;
  if (row.corrections > 0) count_corrected(course, row);
  fmt::print("[{:>{}}/{}] {}\n", course.result.rows.size() + 1, fmt::formatted_size("{}", course.goal.runs),
             course.goal.runs, row_line(course.goal, row));
  std::fflush(stdout);
  course.result.rows.push_back(std::move(row));
}

/// The row with the values of a place, null where they have not been run.
const SearchRow* find_row(const Course& course, const VectorXd& at) {
  const auto values = forming::settings_at(course.goal.variables, at);
  for (const SearchRow& row : course.result.rows)
    if (forming::settings_at(course.goal.variables, row.at) == values) return &row;
  return nullptr;
}

/// The worth of places, nothing where a run failed; fewer where stopped. What has been run is not run again.
std::vector<std::optional<Worth>> ask(Course& course, const std::vector<VectorXd>& places) {
  std::vector<VectorXd> waiting;
  for (const VectorXd& at : places)
    if (!find_row(course, at)) waiting.push_back(at);
  const std::vector<MadeRun> made = waiting.empty() ? std::vector<MadeRun>() : course.runs.make(waiting);
  for (std::size_t i = 0; i < made.size(); ++i) add_row(course, waiting[i], made[i]);
  course.stopped = course.stopped || made.size() < waiting.size();
  std::vector<std::optional<Worth>> found;
  for (const VectorXd& at : places) {
    const SearchRow* row = find_row(course, at);
    if (!row) break;
    found.push_back(row->counted_worth());
  }
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

std::string search_by_least_squares(Course& course, const VectorXd& start, std::size_t runs) {
  using Ending = forming::LeastSquaresResult::Ending;
  const Box box = box_of(course.goal);
  const auto found = forming::least_squares(
      start,
      {box.low, box.high, box.step, runs, Eigen::Index(course.goal.limits.size()), forming::good_norm(course.goal)},
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

std::string search_scalar(Course& course, const VectorXd& start, std::size_t runs) {
  const Box box = box_of(course.goal);
  constexpr double none = -std::numeric_limits<double>::infinity();
  const auto ending = forming::scalar_search(
      start,
      {box.low, box.high, box.step, runs, course.goal.limits.size(), forming::good_value(course.goal).value_or(none)},
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

/// Runs the start and the answer at the accuracy of `confirm` where that has not been done; false where stopped.
bool confirm(Course& course, int jobs) {
  SearchResult& result = course.result;
  if (course.goal.confirm.empty() || !result.rows[result.best].worth) return true;
  const std::string number = result.corrections == 0 ? "" : fmt::format("_{}", result.corrections + 1);
  std::vector<Finer> wanted;
  if (result.confirmed.empty()) wanted.push_back({"start", 0});
  if (result.best != 0 && !result.confirmed_of(result.best)) wanted.push_back({"answer" + number, result.best});
  if (wanted.empty()) return true;
  fmt::print("the {} at {} accuracy with error bars\n",
             wanted.size() > 1 ? "start and the answer" : (result.best == 0 ? "start" : "answer"), course.goal.confirm);
  std::fflush(stdout);
  return run_finer(course.goal, result, wanted, course.output, "confirmed" + number, jobs);
}

/// Adds the difference of the two accuracies at the answer to all runs, those to come too; false where nothing speaks
/// for it or no run is left.
bool correct(Course& course) {
  const Goal& goal = course.goal;
  SearchResult& result = course.result;
  const SearchRow& answer = result.rows[result.best];
  const forming::Confirmed* fine = result.confirmed_of(result.best);
  if (result.corrections >= goal.corrections || result.rows.size() >= goal.runs || !fine || !fine->worth) return false;
  if (!answer.counted_worth() || !forming::is_misled(goal, *answer.counted_worth(), *fine->worth)) return false;
  course.correction = forming::correction_from(answer.outcome, fine->outcome);
  ++result.corrections;
  for (SearchRow& row : result.rows) count_corrected(course, row);
  fmt::print("at {} accuracy the answer is {:.4g}{}, in place of {:.4g}{}: the difference is added to all runs\n",
             goal.confirm, fine->value, fine->holds ? "" : " !", answer.worth->value,
             answer.worth->holds() ? "" : " !");
  std::fflush(stdout);
  return true;
}

/// Searches, and where the finer accuracy does not bear the answer out, searches on corrected by it.
void find_answer(Course& course, int jobs) {
  SearchResult& result = course.result;
  VectorXd start = box_of(course.goal).start;
  for (std::size_t runs = course.goal.runs;; runs = course.goal.runs - result.rows.size() + 1) {
    result.ending = course.goal.target.is_scalar() ? search_scalar(course, start, runs)
                                                   : search_by_least_squares(course, start, runs);
    if (course.stopped) return;
    result.best = forming::best_row(result.rows);
    course.stopped = !confirm(course, jobs);
    if (course.stopped || !correct(course)) break;
    start = result.rows[result.best].at;  // its run is there: one more than are left
  }
  if (result.corrections > 0) result.best = forming::best_confirmed_row(result);
}

void write_report(const Goal& goal, const SearchResult& result, const std::string& output) {
  std::vector<std::string> folders;
  for (const forming::Confirmed& confirmed : result.confirmed)
    if (const std::string folder = output + '/' + confirmed.folder; fs::exists(folder + "/glass.pvd"))
      folders.push_back(folder);
  if (!folders.empty()) report({folders, output + "/report.html", forming::course_text(goal, result)});
}

std::string confirmed_text(const forming::Confirmed* confirmed) {
  if (!confirmed) return "";
  if (!confirmed->reason.empty()) return "  no results: " + confirmed->reason;
  return std::isfinite(confirmed->bar) ? fmt::format("{:>11.4g} +- {:.2g}", confirmed->value, confirmed->bar)
                                       : fmt::format("{:>11.4g}", confirmed->value);
}

/// The start beside the answer: goal, limits, variables.
void print_answer(const Goal& goal, const SearchResult& result) {
  const SearchRow &start = result.rows.front(), &best = result.rows[result.best];
  const auto value = [](const SearchRow& row) {
    return row.counted_worth() ? row.counted_worth()->value : std::nan("");
  };
  fmt::print("\n  {:<40}{:>12}{:>12}\n", result.corrections > 0 ? "corrected by " + goal.confirm : "", "start",
             "answer");
  fmt::print("  {:<40}{:>12.4g}{:>12.4g}\n", forming::what_is_sought(goal), value(start), value(best));
  for (const forming::Limit& limit : goal.limits) {
    const auto at = [&](const SearchRow& row) {
      const forming::Quantity* found = row.counted_outcome().quantities.find(limit.quantity);
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
  if (result.confirmed.empty()) return;
  fmt::print("  at {} accuracy: start {}, answer {}\n", goal.confirm, confirmed_text(result.confirmed_of(0)),
             confirmed_text(result.confirmed_of(result.best)));
  for (const forming::Confirmed& other : result.confirmed)
    if (other.row != 0 && other.row != result.best)
      fmt::print("    worse there: {}{}{}\n", other.folder, confirmed_text(&other),
                 other.worth && !other.holds ? ", misses a limit" : "");
}

int close_search(const Goal& goal, Course& course) {
  SearchResult& result = course.result;
  write_report(goal, result, course.output);
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
  const Worth& worth = *forming::worth_of_answer(result);
  if (!worth.holds()) {
    fmt::print(stderr, "parison: no run that was made holds all limits; the answer misses them least\n");
    return run_failed;
  }
  if (const auto good = forming::good_value(goal); good && worth.value > *good) {
    const double sign = goal.target.kind == forming::Target::Kind::most ? -1 : 1;
    fmt::print(stderr, "parison: no run that was made reaches {:g}; the answer is the nearest, {:.4g}\n", sign * *good,
               sign * worth.value);
    return run_failed;
  }
  return 0;
}

/// The folder of the search, before the first run.
void claim(const Goal& goal, const std::string& output) {
  std::set<std::string> names{"case", "step_*", "confirmed*", "runs.csv", "result.json", "wall.csv", "report.html"};
  for (const forming::Tool& tool : forming::read_scene(goal.case_path, goal.accuracy).tools)
    names.insert(tool.name + ".dxf");
  core::claim_folder(output, "optimise", names);
  core::require_own(output + "/case");
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
  claim(goal, output);
  const FolderLock lock(output);
  Course course{goal, output, SearchRuns(goal, output, jobs)};
  find_answer(course, jobs);
  if (!course.stopped) return close_search(goal, course);
  fmt::print(stderr, "parison: stopped on request; the same command goes on with it\n");
  return run_failed;
}

}  // namespace parison::tools
