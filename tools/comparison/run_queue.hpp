#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/study/comparison/what_if/what_if.hpp"

namespace parison::tools {

/// What became of a planned run.
struct QueuedRun {
  enum class Status { waiting, running, done, failed };
  forming::PlannedRun plan;
  Status status = Status::waiting;
  int child = 0;
  std::string reason = {};  ///< why it failed
};

/// Runs what is planned as processes of their own, so many at once, each as soon as what it needs is there. A run that
/// is in its folder already is taken as it is, a stopped one goes on. False where stopped on request. Throws
/// core::CaseError before anything runs where a folder has a run of another case or of other settings.
bool run_all(std::vector<QueuedRun>& runs, const std::string& case_path, int jobs);

/// CPU time of all processes that this one started and that have ended, s.
double cpu_of_children();

}  // namespace parison::tools
