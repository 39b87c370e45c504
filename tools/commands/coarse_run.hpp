#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/run/run_observer.hpp"
#include "forming/scene/scene.hpp"

namespace parison::tools {

/// The coarse run of the error bars, parallel to its run on another core; its destructor asks a running one to stop
/// and waits until it has.
class CoarseRun : public forming::RunObserver {
 public:
  /// Of the run of a scene in a folder.
  CoarseRun(const forming::Scene& scene, std::string directory);
  ~CoarseRun() override;

  /// Starts it after the first step of its run, where this process may use a second core.
  void step_taken(const forming::RunView& run, const forming::State& before,
                  const forming::StepReport& report) override;

  /// Returns when it has ended, and prints that it waits; a request to stop is passed on.
  void wait();

 private:
  bool has_ended();

  const forming::Scene& scene_;
  std::string directory_;
  bool started_ = false;
  int child_ = 0;  ///< 0 where none runs
};

}  // namespace parison::tools
