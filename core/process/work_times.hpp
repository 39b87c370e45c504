#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::core {

/// Time on the wall clock that kinds of work have taken in the calling thread so far, s. A run finds the share of a
/// kind in a part of its time from the values before and after.
struct WorkTimes {
  double factorisation = 0;  ///< of the direct solvers, numeric; the analysis does not count
  double solution = 0;       ///< of the direct solvers, forward and back-substitution
  double radiation = 0;      ///< light in the glass and between surfaces
};
WorkTimes work_times();

/// Adds the time between its construction and destruction to one of its thread's work times. A factorisation may be so
/// short that asking the system for the CPU time would take a per cent of it.
class WorkTimer {
 public:
  explicit WorkTimer(double WorkTimes::*work);
  ~WorkTimer();
  WorkTimer(const WorkTimer&) = delete;
  WorkTimer& operator=(const WorkTimer&) = delete;

 private:
  double WorkTimes::*work_;
  double start_;
};

}  // namespace parison::core
