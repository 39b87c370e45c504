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
#include "tools/sweep/slurm_engine.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::SweepPlan;
using forming::SweepState;
using Status = SweepState::Status;

std::size_t count(const std::vector<SweepState>& states, Status status) {
  return static_cast<std::size_t>(
      std::count_if(states.begin(), states.end(), [&](const SweepState& state) { return state.status == status; }));
}

std::size_t sharing(const SweepPlan& plan) {
  return static_cast<std::size_t>(std::count_if(plan.runs.begin(), plan.runs.end(),
                                                [](const forming::SweepRun& run) { return run.start.has_value(); }));
}

void print_opening(const SweepPlan& plan, const std::vector<SweepState>& states, const std::string& engine) {
  fmt::print("{} at {} accuracy: {} runs, {}, in {}\n", plan.sweep.case_path, plan.sweep.accuracy, plan.runs.size(),
             engine, plan.output);
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

/// A task of Slurm: one row of a sweep that was begun. Another task that was taken for lost may still be about to stop.
int make_row_alone(const SweepRequest& request, const forming::Sweep& asked, const std::string& output) {
  constexpr double patience = 120;  // s
  const SweepPlan plan = forming::begun_plan(asked, output);
  if (request.row > plan.runs.size())
    throw core::CaseError(fmt::format("--row: {} was found, allowed is 1 to {}", request.row, plan.runs.size()));
  catch_signals();
  return make_row(plan, request.row - 1, patience);
}

void require_engine(const SweepRequest& request) {
  if (request.engine != "slurm" && !request.slurm_options.empty())
    throw core::CaseError(
        "--partition, --time or --slurm-option was found without --engine slurm, allowed only with it");
  for (const std::string& option : request.slurm_options)
    if (option.size() < 2 || option.front() != '-')
      throw core::CaseError(
          fmt::format("--slurm-option: \"{}\" was found, allowed is an option of sbatch, such as --mem=2G", option));
}

/// Makes the runs; false where asked to stop before their end.
bool make_runs(const SweepRequest& request, const SweepPlan& plan, const SlurmJobs& slurm,
               std::vector<SweepState>& states) {
  if (request.engine == "slurm") {
    print_opening(plan, states, "as tasks of Slurm named " + slurm.name);
    return run_sweep_by_slurm(plan, states, slurm);
  }
  const int jobs = request.jobs > 0 ? request.jobs : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  print_opening(plan, states, fmt::format("{} at once", jobs));
  return run_sweep(plan, states, jobs);
}

}  // namespace

int sweep(const SweepRequest& request) {
  require_engine(request);
  forming::Sweep asked = forming::read_sweep(request.file);
  asked.case_path = case_named(asked.directory, asked.case_path);
  const std::string output = request.output.empty() ? "results/sweep_" + asked.name : request.output;
  if (request.row > 0) return make_row_alone(request, asked, output);
  const SweepPlan plan = forming::plan_sweep(asked, output);
  if (request.list) {
    print_list(plan);
    return 0;
  }
  SlurmJobs slurm = slurm_jobs(plan, request.slurm_options, request.jobs);
  if (request.engine == "slurm") require_slurm(slurm);
  catch_signals();
  forming::claim_sweep(plan);
  const FolderLock lock(plan.output);
  forming::write_manifest(plan);
  std::vector<SweepState> states;
  states.reserve(plan.runs.size());
  for (const forming::SweepRun& run : plan.runs) states.push_back(forming::state_of(plan, run));
  // A table of before is of the runs as they are now, also where this call is killed.
  if (fs::exists(plan.output + "/results.csv")) forming::write_results(plan, forming::read_results(plan, states));
  const double begin = core::wall_seconds();
  const bool ended = make_runs(request, plan, slurm, states);
  return close_sweep(plan, states, !ended, core::wall_seconds() - begin);
}

}  // namespace parison::tools
