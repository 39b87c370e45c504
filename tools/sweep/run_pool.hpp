#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <deque>
#include <string>
#include <vector>

#include "forming/study/sweep/sweep_plan.hpp"

namespace parison::tools {

/// Whether a line is printed for runs that end.
enum class Report { progress, none };

/// What is known of the runs of a sweep while they are made, whoever makes them; a run is named by its row.
struct Progress {
  const forming::SweepPlan& plan;
  std::vector<forming::SweepState>& states;
  Report report = Report::progress;
  std::vector<std::vector<std::size_t>> followers = {};  ///< the rows that take over from each
  std::vector<std::size_t> unfinished_followers = {};
  std::deque<std::size_t> ready = {};  ///< wait for no other run
  std::size_t ended = 0, ended_here = 0;
  double begin = 0, last_report = 0;
};

/// The rows that are done are counted, of the others those that wait for none are ready.
Progress open_progress(const forming::SweepPlan& plan, std::vector<forming::SweepState>& states, Report report);

/// Notes a run that is done or has failed: those that waited for it are ready, a line is printed.
void end_run(Progress& progress, std::size_t row, const forming::SweepState& state);

/// Makes a run, or what is left of it, unless it has ended; for one that another process makes it waits so long, s. On
/// an error its sentence goes to the standard error. Returns the exit code.
int make_row(const forming::SweepPlan& plan, std::size_t row, double patience = 0);

/// What a run prints.
std::string log_path(const forming::SweepPlan& plan, std::size_t row);

/// What a run printed last; its log goes where it is empty.
std::string last_words(const std::string& path);

/// Makes the runs of a sweep that are not done, so many at once, each in a copy of this process; a run that takes over
/// the first stages of another one waits for that. False where stopped on request; then some states are still
/// `waiting`.
bool run_sweep(const forming::SweepPlan& plan, std::vector<forming::SweepState>& states, int jobs,
               Report report = Report::progress);

}  // namespace parison::tools
