#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "forming/study/sweep/sweep_plan.hpp"

namespace parison::tools {

/// Whether a line is printed for runs that end.
enum class Report { progress, none };

/// Makes the runs of a sweep that are not done, so many at once, each in a copy of this process; a run that takes over
/// the first stages of another one waits for that. False where stopped on request; then some
/// states are still `waiting`.
bool run_sweep(const forming::SweepPlan& plan, std::vector<forming::SweepState>& states, int jobs,
               Report report = Report::progress);

}  // namespace parison::tools
