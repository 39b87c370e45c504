#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "forming/study/sweep/sweep_plan.hpp"

namespace parison::tools {

/// Tasks of a sweep in the queue of Slurm; a task makes a row.
struct SlurmJobs {
  std::string name;                  ///< of all jobs of the sweep
  std::string script;                ///< gets the row of array index 0 and is run once for each index
  std::string messages;              ///< file to which all tasks append what Slurm says
  std::vector<std::string> options;  ///< of sbatch, as the user gives them
  int at_once = 0;                   ///< tasks of an array; 0: as many as Slurm lets
  std::size_t array_size = 1001;     ///< indices that an array may have
};

/// The option of sbatch and squeue for a list of array indices, in ranges: "0-3,7".
std::string index_ranges(const std::vector<std::size_t>& indices);

/// Asks Slurm whether it would take such tasks, and for the size of an array. Throws core::CaseError with what it says
/// where there is no Slurm, it does not answer or refuses.
void require_slurm(SlurmJobs& jobs);

/// The rows that have a task in the queue, waiting or running; nothing where Slurm does not answer.
std::optional<std::set<std::size_t>> rows_in_queue(const SlurmJobs& jobs);

/// Hands rows in ascending order to Slurm. Returns what Slurm said where it refused, and removes from `rows` those
/// that it took.
std::string submit(const SlurmJobs& jobs, std::vector<std::size_t>& rows);

/// The jobs of a sweep: `at_once` tasks of an array at a time, all where it is 0. Nothing is asked or written yet.
SlurmJobs slurm_jobs(const forming::SweepPlan& plan, std::vector<std::string> options, int at_once);

/// Makes the runs of a sweep that are not done as tasks of Slurm, hands in again those that were lost, and waits for
/// them; tasks of before that are still in the queue are waited for and not handed in again. Prints how far it is.
/// False where it was asked to stop waiting; the tasks then go on.
bool run_sweep_by_slurm(const forming::SweepPlan& plan, std::vector<forming::SweepState>& states,
                        const SlurmJobs& jobs);

}  // namespace parison::tools
