#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::core {

/// CPU time that kinds of work have taken in the calling thread so far, s. A run finds the share of a kind in a part of
/// its time from the values before and after.
struct WorkTimes {
  double factorisation = 0;  ///< of the direct solvers, numeric; the analysis does not count
  double solution = 0;       ///< of the direct solvers, forward and back-substitution
  double radiation = 0;      ///< light in the glass and between surfaces
};
WorkTimes work_times();

/// Adds the CPU time of this thread between its construction and destruction to one of its work times.
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
