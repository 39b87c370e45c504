#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::forming {

/// Whether a path is the result folder of a run that has ended.
bool is_result_folder(const std::string& path);

/// The case that a finished run was made of, as it was.
struct FinishedBase {
  std::string case_path, accuracy;
  std::vector<std::string> overrides;
};

/// Throws core::CaseError where the run in a result folder cannot be the base of a what-if: it has not completed,
/// another build of the program has made it, or nothing has its case as it was.
FinishedBase read_finished_base(const std::string& directory);

/// Whether a folder has the results of a run that this build of the program has completed.
bool has_completed_here(const std::string& directory);

/// Copies the results of the run that a planned one is a copy of, without those of other runs in its folder.
void copy_results(const PlannedRun& run);

}  // namespace parison::forming
