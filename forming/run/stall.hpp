#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <optional>
#include <string>

#include "forming/diagnostics/diagnostics.hpp"

namespace parison::forming {

/// Finds out in a stage whether a run has no use to go on.
class StallWatch {
 public:
  /// Why the run of an accepted state has none, a sentence: glass is deep in a tool, behind a face without contact, or
  /// hundreds of steps were about as short as steps may be while thousands like them are to come. Empty where it has.
  std::string reason(const Scene& scene, const State& state, const Diagnostics& seen);

 private:
  /// Where the present count of steps began.
  struct Start {
    Index steps, short_steps;
    double time;  ///< s
  };
  std::optional<Start> start_;
};

}  // namespace parison::forming
