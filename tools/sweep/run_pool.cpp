// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/sweep/run_pool.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <map>
#include <utility>

#include "core/io/files.hpp"
#include "core/io/written_files.hpp"
#include "core/process/clock.hpp"
#include "core/process/gmsh_module.hpp"
#include "tools/program/child_process.hpp"
#include "tools/program/folder_lock.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {

namespace {

namespace fs = std::filesystem;
using forming::SweepPlan;
using forming::SweepState;
using Status = SweepState::Status;

constexpr double between_reports = 1.0;  ///< s

std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  return seconds < 6000 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

/// A line each second, and one for each run that failed.
void print_end(Progress& progress, std::size_t row) {
  if (progress.report == Report::none) return;
  const SweepState& state = progress.states[row];
  const std::size_t count = progress.plan.runs.size();
  const double now = core::wall_seconds();
  const bool has_failed = state.status == Status::failed;
  if (!has_failed && now - progress.last_report < between_reports && progress.ended < count) return;
  progress.last_report = now;
  const double left = (now - progress.begin) / double(progress.ended_here) * double(count - progress.ended);
  fmt::print("[{:>{}}/{}] {} {}{}\n", progress.ended, fmt::formatted_size("{}", count), count,
             progress.plan.runs[row].name, has_failed ? "no results: " + state.reason : "done",
             progress.ended < count ? fmt::format("; {} left", duration_text(left)) : "");
  std::fflush(stdout);
}

/// Removes what is not to be kept of a run that is done and from which none will take over any more.
void tidy_up(const Progress& progress, std::size_t row) {
  const std::string folder = progress.plan.folder(progress.plan.runs[row]);
  const auto& first = progress.plan.first;
  const bool is_over = progress.states[row].status == Status::done && progress.unfinished_followers[row] == 0;
  if (is_over && !(first && first->folder == folder)) forming::keep_only(progress.plan.sweep.keep, folder);
}

/// Counts a run that is done or has failed.
void note_end(Progress& progress, std::size_t row) {
  ++progress.ended;
  tidy_up(progress, row);
  if (const auto& start = progress.plan.runs[row].start) {
    --progress.unfinished_followers[start->run];
    tidy_up(progress, start->run);
  }
}

}  // namespace

Progress open_progress(const SweepPlan& plan, std::vector<SweepState>& states, Report report) {
  Progress progress{plan, states, report};
  progress.begin = core::wall_seconds();
  progress.followers.resize(plan.runs.size());
  progress.unfinished_followers.resize(plan.runs.size());
  for (std::size_t row = 0; row < plan.runs.size(); ++row)
    if (const auto& start = plan.runs[row].start) {
      ++progress.unfinished_followers[start->run];
      progress.followers[start->run].push_back(row);
    }
  for (std::size_t row = 0; row < plan.runs.size(); ++row) {
    const auto& start = plan.runs[row].start;
    if (states[row].status != Status::waiting)
      note_end(progress, row);
    else if (!start || states[start->run].status != Status::waiting)
      progress.ready.push_back(row);
  }
  return progress;
}

void end_run(Progress& progress, std::size_t row, const SweepState& state) {
  progress.states[row] = state;
  ++progress.ended_here;
  note_end(progress, row);
  for (const std::size_t follower : progress.followers[row])
    if (progress.states[follower].status == Status::waiting) progress.ready.push_front(follower);
  print_end(progress, row);
}

int make_row(const SweepPlan& plan, std::size_t row, double patience) {
  const forming::SweepRun& run = plan.runs[row];
  try {
    FileLock lock(plan.folder(run) + ".lock");
    if (!lock.is_held(patience)) {
      fmt::print(stderr, "another process makes {}\n", run.name);
      return 1;
    }
    if (forming::state_of(plan, run).status == Status::waiting) forming::make_run(plan, run, stop_requested);
    if (forming::state_of(plan, run).status != Status::waiting) lock.remove();
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}

std::string log_path(const SweepPlan& plan, std::size_t row) {
  return plan.folder(plan.runs[row]) + ".log";
}

std::string last_words(const std::string& path) {
  std::error_code unreadable;
  if (!fs::exists(path, unreadable)) return {};
  std::string text = core::read_text(path);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (text.empty()) core::remove_own(path);
  return text.substr(text.rfind('\n') + 1);
}

namespace {

constexpr double longest_wait = 0.2;  ///< s, after which a request to stop is looked for

using Running = std::map<int, std::size_t>;  ///< rows by the ids of their processes

void start_next(Progress& progress, Running& running) {
  const std::size_t row = progress.ready.front();
  progress.ready.pop_front();
  const std::string log = log_path(progress.plan, row);
  core::remove_own(log);
  running[start_work([&] { return make_row(progress.plan, row); }, log)] = row;
}

void collect(Progress& progress, std::size_t row) {
  const std::string words = last_words(log_path(progress.plan, row));
  SweepState state = forming::state_of(progress.plan, progress.plan.runs[row]);
  if (state.status == Status::waiting) {
    if (stop_requested()) return;
    const std::string interrupted =
        state.reason.empty() ? "its process was ended from outside" : "it was interrupted in " + state.reason;
    state = {Status::failed, words.empty() ? interrupted + "; the same command goes on with it" : words};
  }
  end_run(progress, row, state);
}

void collect_ended(Progress& progress, Running& running) {
  for (auto run = running.begin(); run != running.end();)
    if (const auto [child, row] = *run; has_ended(child)) {
      run = running.erase(run);
      collect(progress, row);
    } else {
      ++run;
    }
}

}  // namespace

bool run_sweep(const SweepPlan& plan, std::vector<SweepState>& states, int jobs, Report report) {
  expect_children();
  Progress progress = open_progress(plan, states, report);
  if (!progress.ready.empty()) core::open_gmsh_module();  // once, not in the copy of each run
  Running running;
  bool passed_on = false;
  for (;;) {
    while (!stop_requested() && !progress.ready.empty() && running.size() < static_cast<std::size_t>(jobs))
      start_next(progress, running);
    if (stop_requested() && !std::exchange(passed_on, true))
      for (const auto& [child, row] : running) request_stop(child);
    if (running.empty()) return progress.ended == plan.runs.size();
    await_end_of_child(longest_wait);
    collect_ended(progress, running);
  }
}

}  // namespace parison::tools
