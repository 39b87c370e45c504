// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "core/case/case_error.hpp"
#include "core/process/clock.hpp"
#include "forming/study/sweep/sweep_plan.hpp"
#include "forming/study/sweep/sweep_table.hpp"
#include "tools/program/bundled_cases.hpp"
#include "tools/program/exit_codes.hpp"
#include "tools/program/folder_lock.hpp"
#include "tools/program/stop_request.hpp"
#include "tools/sweep/run_pool.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::SweepPlan;
using forming::SweepState;
using Status = SweepState::Status;

/// The case of a sweep: beside the sweep file where it is there, else as every command finds it.
std::string case_of(const forming::Sweep& sweep) {
  const fs::path beside = fs::path(sweep.directory) / sweep.case_path;
  std::error_code unknown;
  return fs::exists(beside, unknown) ? beside.string() : find_case(sweep.case_path);
}

std::size_t count(const std::vector<SweepState>& states, Status status) {
  return static_cast<std::size_t>(
      std::count_if(states.begin(), states.end(), [&](const SweepState& state) { return state.status == status; }));
}

std::size_t sharing(const SweepPlan& plan) {
  return static_cast<std::size_t>(std::count_if(plan.runs.begin(), plan.runs.end(),
                                                [](const forming::SweepRun& run) { return run.start.has_value(); }));
}

void print_opening(const SweepPlan& plan, const std::vector<SweepState>& states, int jobs) {
  fmt::print("{} at {} accuracy: {} runs, {} at once, in {}\n", plan.sweep.case_path, plan.sweep.accuracy,
             plan.runs.size(), jobs, plan.output);
  if (const std::size_t some = sharing(plan); some > 0)
    fmt::print("  {} of them start from the end of a stage that another one has made\n", some);
  if (const std::size_t done = plan.runs.size() - count(states, Status::waiting); done > 0)
    fmt::print("  {} of them are there from before\n", done);
  std::fflush(stdout);
}

void print_list(const SweepPlan& plan) {
  for (const forming::SweepRun& run : plan.runs) {
    std::string line = run.name;
    for (std::size_t i = 0; i < run.values.size(); ++i)
      line += fmt::format("  {}={}", plan.sweep.variables[i].key, run.values[i]);
    if (run.start) line += fmt::format("  (after {} of {})", run.start->stage, plan.runs[run.start->run].name);
    fmt::print("{}\n", line);
  }
}

/// The range of each quantity over the runs.
void print_ranges(const SweepPlan& plan, const forming::SweepTable& table) {
  fmt::print("\n  {:<24}{:>12}{:>12}  {:<12}{:<10} {}\n", "quantity", "smallest", "largest", "unit", "smallest",
             "largest");
  for (const forming::QuantityColumn& column : table.quantities) {
    const auto less = [](double a, double b) { return std::isnan(b) ? !std::isnan(a) : a < b; };
    const auto more = [](double a, double b) { return std::isnan(b) ? !std::isnan(a) : a > b; };
    const auto low = std::min_element(column.values.begin(), column.values.end(), less),
               high = std::min_element(column.values.begin(), column.values.end(), more);
    const auto name = [&](auto at) { return plan.runs[static_cast<std::size_t>(at - column.values.begin())].name; };
    fmt::print("  {:<24}{:>12.5g}{:>12.5g}  {:<12}{:<10} {}\n", column.name, *low, *high, column.unit, name(low),
               name(high));
  }
}

int close_sweep(const SweepPlan& plan, const std::vector<SweepState>& states, bool stopped, double seconds) {
  const forming::SweepTable table = forming::read_results(plan, states);
  forming::write_results(plan, table);
  const std::size_t failed = count(states, Status::failed);
  if (count(states, Status::done) > 0) print_ranges(plan, table);
  fmt::print("\n  {} runs done, {} failed, {} not run, in {:.1f} s; {}/results.csv and results.h5\n",
             count(states, Status::done), failed, count(states, Status::waiting), seconds, plan.output);
  if (stopped) fmt::print(stderr, "parison: stopped on request; the same command goes on with it\n");
  return stopped || failed > 0 ? run_failed : 0;
}

}  // namespace

int sweep(const SweepRequest& request) {
  forming::Sweep asked = forming::read_sweep(request.file);
  asked.case_path = case_of(asked);
  const SweepPlan plan =
      forming::plan_sweep(asked, request.output.empty() ? "results/sweep_" + asked.name : request.output);
  if (request.list) {
    print_list(plan);
    return 0;
  }
  const int jobs = request.jobs > 0 ? request.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  catch_signals();
  fs::create_directories(plan.output);
  const FolderLock lock(plan.output);
  forming::write_manifest(plan);
  std::vector<SweepState> states;
  states.reserve(plan.runs.size());
  for (const forming::SweepRun& run : plan.runs) states.push_back(forming::state_of(plan, run));
  print_opening(plan, states, jobs);
  const double begin = core::wall_seconds();
  const bool ended = run_sweep(plan, states, jobs);
  return close_sweep(plan, states, !ended, core::wall_seconds() - begin);
}

}  // namespace parison::tools
