// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/sweep/run_pool.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <deque>
#include <exception>
#include <filesystem>
#include <map>
#include <utility>

#include "core/io/files.hpp"
#include "core/process/clock.hpp"
#include "tools/program/child_process.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::SweepPlan;
using forming::SweepState;
using Status = SweepState::Status;

constexpr double longest_wait = 0.2;     ///< s, after which a request to stop is looked for
constexpr double between_reports = 1.0;  ///< s

/// What is known of the runs while they are made; a run is named by its row.
struct Pool {
  const SweepPlan& plan;
  std::vector<SweepState>& states;
  Report report = Report::progress;
  std::vector<std::vector<std::size_t>> followers = {};  ///< the rows that take over from each
  std::vector<std::size_t> unfinished_followers = {};
  std::deque<std::size_t> ready = {};
  std::map<int, std::size_t> running = {};  ///< by the id of its process
  std::size_t ended = 0, ended_here = 0, failed = 0;
  double begin = core::wall_seconds(), last_report = 0;
};

std::string log_path(const Pool& pool, std::size_t row) {
  return pool.plan.folder(pool.plan.runs[row]) + ".log";
}

/// What a run said last, where it has left no summary; its log goes where it is empty.
std::string last_words(const std::string& path) {
  std::error_code unreadable;
  if (!fs::exists(path, unreadable)) return {};
  std::string text = core::read_text(path);
  while (!text.empty() && text.back() == '\n') text.pop_back();
  if (text.empty()) fs::remove(path, unreadable);
  return text.substr(text.rfind('\n') + 1);
}

std::string duration_text(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  return seconds < 6000 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

/// A line each second, and one for each run that failed.
void report(Pool& pool, std::size_t row) {
  if (pool.report == Report::none) return;
  const SweepState& state = pool.states[row];
  const std::size_t count = pool.plan.runs.size();
  const double now = core::wall_seconds();
  const bool has_failed = state.status == Status::failed;
  if (!has_failed && now - pool.last_report < between_reports && pool.ended < count) return;
  pool.last_report = now;
  const double left = (now - pool.begin) / double(pool.ended_here) * double(count - pool.ended);
  fmt::print("[{:>{}}/{}] {} {}{}\n", pool.ended, fmt::formatted_size("{}", count), count, pool.plan.runs[row].name,
             has_failed ? "no results: " + state.reason : "done",
             pool.ended < count ? fmt::format("; {} left", duration_text(left)) : "");
  std::fflush(stdout);
}

/// Removes what is not to be kept of a run that is done and from which none will take over any more.
void tidy_up(const Pool& pool, std::size_t row) {
  if (pool.states[row].status == Status::done && pool.unfinished_followers[row] == 0)
    forming::keep_only(pool.plan.sweep.keep, pool.plan.folder(pool.plan.runs[row]));
}

/// Counts a run that is done or has failed.
void note_end(Pool& pool, std::size_t row) {
  ++pool.ended;
  if (pool.states[row].status == Status::failed) ++pool.failed;
  tidy_up(pool, row);
  if (const auto& start = pool.plan.runs[row].start) {
    --pool.unfinished_followers[start->run];
    tidy_up(pool, start->run);
  }
}

/// The rows that are done are counted, of the others those that wait for none are ready.
Pool open_pool(const SweepPlan& plan, std::vector<SweepState>& states, Report report) {
  Pool pool{plan, states, report};
  pool.followers.resize(plan.runs.size());
  pool.unfinished_followers.resize(plan.runs.size());
  for (std::size_t row = 0; row < plan.runs.size(); ++row)
    if (const auto& start = plan.runs[row].start) {
      ++pool.unfinished_followers[start->run];
      pool.followers[start->run].push_back(row);
    }
  for (std::size_t row = 0; row < plan.runs.size(); ++row) {
    const auto& start = plan.runs[row].start;
    if (states[row].status != Status::waiting)
      note_end(pool, row);
    else if (!start || states[start->run].status != Status::waiting)
      pool.ready.push_back(row);
  }
  return pool;
}

int work_on(const SweepPlan& plan, std::size_t row) {
  try {
    forming::make_run(plan, plan.runs[row], stop_requested);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}

void start_next(Pool& pool) {
  const std::size_t row = pool.ready.front();
  pool.ready.pop_front();
  fs::remove(log_path(pool, row));
  const int child = start_work([&] { return work_on(pool.plan, row); }, log_path(pool, row));
  pool.running[child] = row;
}

void collect(Pool& pool, int child) {
  const std::size_t row = pool.running.at(child);
  pool.running.erase(child);
  const std::string words = last_words(log_path(pool, row));
  SweepState state = forming::state_of(pool.plan, pool.plan.runs[row]);
  if (state.status == Status::waiting) {
    if (stop_requested()) return;
    state = {Status::failed, words.empty() ? "its process was ended from outside" : words};
  }
  pool.states[row] = state;
  ++pool.ended_here;
  note_end(pool, row);
  for (const std::size_t follower : pool.followers[row])
    if (pool.states[follower].status == Status::waiting) pool.ready.push_front(follower);
  report(pool, row);
}

}  // namespace

bool run_sweep(const SweepPlan& plan, std::vector<SweepState>& states, int jobs, Report report) {
  expect_children();
  Pool pool = open_pool(plan, states, report);
  bool passed_on = false;
  for (;;) {
    while (!stop_requested() && !pool.ready.empty() && pool.running.size() < static_cast<std::size_t>(jobs))
      start_next(pool);
    if (stop_requested() && !std::exchange(passed_on, true))
      for (const auto& [child, row] : pool.running) request_stop(child);
    if (pool.running.empty()) return pool.ended == plan.runs.size();
    if (const int child = ended_child(longest_wait); child != 0) collect(pool, child);
  }
}

}  // namespace parison::tools
