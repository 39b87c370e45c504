#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::core {

/// CPU time that the direct solvers have taken in the calling thread so far, s.
struct SolverTimes {
  double factorisation = 0;  ///< numeric; the analysis does not count
  double solution = 0;       ///< forward and back-substitution
};
SolverTimes solver_times();

/// Adds the CPU time of this thread between its construction and destruction to the solver times.
class SolverTimer {
 public:
  enum class Work { factorisation, solution };
  explicit SolverTimer(Work work);
  ~SolverTimer();
  SolverTimer(const SolverTimer&) = delete;
  SolverTimer& operator=(const SolverTimer&) = delete;

 private:
  Work work_;
  double start_;
};

}  // namespace parison::core
