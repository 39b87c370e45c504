// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/sweep/run_pool.hpp"

#include <filesystem>
#include <map>
#include <utility>

#include "core/io/written_files.hpp"
#include "core/process/gmsh_module.hpp"
#include "tools/program/child_process.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

namespace fs = std::filesystem;
using forming::SweepPlan;
using forming::SweepState;
using Status = SweepState::Status;

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
