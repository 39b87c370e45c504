#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include "forming/scene/scene.hpp"

namespace parison::tools {

/// The companion run of the error bars, beside its run on another core; whoever drops it while it runs asks it to stop
/// and waits until it has.
class CompanionRun {
 public:
  /// Of the run of a scene in a folder.
  CompanionRun(const forming::Scene& scene, std::string directory);
  CompanionRun(const CompanionRun&) = delete;
  ~CompanionRun();

  /// Starts it, once and where this process may use a second core; the folder is there.
  void start();

  /// Returns when it has ended, and tells that it waits; a request to stop is passed on.
  void wait();

 private:
  bool has_ended();

  const forming::Scene& scene_;
  std::string directory_;
  bool started_ = false;
  int child_ = 0;  ///< 0 where none runs
};

}  // namespace parison::tools
