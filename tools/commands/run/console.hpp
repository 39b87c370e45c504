#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/run_observer.hpp"
#include "tools/commands/run/remaining_time.hpp"

namespace parison::tools {

/// Prints a line about the progress of a run, at the most once a second.
class Console : public forming::RunObserver {
 public:
  void run_begins(const forming::RunView& run) override;
  void stage_begins(const forming::RunView& run) override;
  void step_taken(const forming::RunView& run, const forming::State& before,
                  const forming::StepReport& report) override;
  void solid_step_taken(const forming::RunView& run, const forming::SolidState& solid) override;

 private:
  void print_line(const forming::RunView& run, double step);

  double start_ = 0, last_line_ = 0;  ///< wall clock, s
  double shown_ = 0;                  ///< share of the run that the last line told as done; it never goes back
  RemainingTime remaining_;
};

}  // namespace parison::tools
