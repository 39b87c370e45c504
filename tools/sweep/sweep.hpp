#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <string>
#include <vector>

namespace parison::tools {

/// What `parison sweep` is asked for.
struct SweepRequest {
  std::string file, output;
  int jobs = 0;  ///< at once; 0: as many as there are cores, or as Slurm lets
  bool list = false;
  std::string engine = "local";                 ///< or "slurm"
  std::vector<std::string> slurm_options = {};  ///< of sbatch
  std::size_t row = 0;                          ///< this one alone, counted from 1, of a sweep that was begun; 0: all
};

/// Runs a sweep, or what is left of it, and writes the table of its results. Returns the exit code.
int sweep(const SweepRequest& request);

}  // namespace parison::tools
