#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "forming/run/run_observer.hpp"
#include "forming/study/coarse_run.hpp"
#include "tools/commands/run/run_command.hpp"

namespace parison::tools {

/// The coarser runs of the error bars, one after the other beside their run on another core; the destructor asks a
/// running one to stop and waits until it has.
class CoarseRuns : public forming::RunObserver {
 public:
  explicit CoarseRuns(std::vector<forming::CoarseCase> cases);
  ~CoarseRuns() override;

  /// Starts the first after the first step of the run and each of the others when the one before has ended, where this
  /// process may use a second core.
  void step_taken(const forming::RunView& run, const forming::State& before,
                  const forming::StepReport& report) override;

  /// Returns when all that were begun here have ended, and prints that it waits; a request to stop is passed on.
  void wait();

  const std::vector<forming::CoarseCase>& cases() const { return cases_; }

 private:
  bool has_ended();
  void start_next();

  std::vector<forming::CoarseCase> cases_;
  std::size_t started_ = 0;
  int child_ = 0;  ///< 0 where none runs
};

/// Runs a case into a new folder as often as it takes for the accuracy that is asked for as a share, ever finer. The
/// folder keeps the last run. Returns the exit code of the program.
int run_to_accuracy(RunRequest request, double target);

}  // namespace parison::tools
