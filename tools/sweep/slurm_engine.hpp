#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/sweep/sweep_plan.hpp"
#include "tools/sweep/slurm_queue.hpp"

namespace parison::tools {

/// The jobs of a sweep: `at_once` tasks of an array at a time, all where it is 0. Nothing is asked or written yet.
SlurmJobs slurm_jobs(const forming::SweepPlan& plan, std::vector<std::string> options, int at_once);

/// Makes the runs of a sweep that are not done as tasks of Slurm, hands in again those that were lost, and waits for
/// them; tasks of before that are still in the queue are waited for and not handed in again. Prints how far it is.
/// False where it was asked to stop waiting; the tasks then go on.
bool run_sweep_by_slurm(const forming::SweepPlan& plan, std::vector<forming::SweepState>& states,
                        const SlurmJobs& jobs);

}  // namespace parison::tools
