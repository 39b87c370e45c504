#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <string>

#include "forming/report/files/result_files.hpp"
#include "forming/run/checkpoint.hpp"
#include "forming/run/run.hpp"
#include "forming/step/workspace.hpp"

namespace parison::forming {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start);
double cpu_seconds_of_process();

/// A run in progress.
struct Progress {
  const Scene& scene;
  const StopRequest& stop;
  ResultFiles files;
  RunOutcome outcome;
  Workspace workspace = {};
  Clock::time_point start = Clock::now(), last_line = start, last_checkpoint = start;
  double cpu_start = cpu_seconds_of_process();
  double cpu_before = 0;        ///< CPU time of the run up to its last checkpoint likewise, s
  double wall_before = 0;       ///< wall time of the run up to its last checkpoint when it was taken up again, s
  double fraction_before = 0;   ///< of the simulated time that was done by then
  Index checkpoint_steps = -1;  ///< steps done at the last checkpoint, -1 before the first
};

/// Accumulates the time since `start` under a part of the run.
void account(Progress& run, const char* part, Clock::time_point start);

/// Puts the wall and CPU time of the whole run into its facts.
void update_times(Progress& run);

/// Of the longest time that all stages can take.
double fraction_done(const Progress& run);

/// A line for the terminal, at the most once a second.
void print_progress(Progress& run, const StepReport& report);

/// A state, that of the run or one within its last step, into the result files.
void write_fields(Progress& run, const State& state);

/// Writes a checkpoint where one can be written: not while the heat of a static stage is in an integrator with a
/// memory of its own, which ends after `output.checkpoint_steps` steps and after 300 of its own.
void save(Progress& run);

/// The same when the case's time or steps between checkpoints are over.
void save_when_due(Progress& run);

}  // namespace parison::forming
