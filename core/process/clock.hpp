#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later

namespace parison::core {

/// Time on the wall clock since an arbitrary moment, s; it never goes back.
double wall_seconds();

/// CPU time of the calling thread so far, s. Other threads of the process do not count, so that runs in several threads
/// are timed apart.
double thread_cpu_seconds();

/// Adds the wall time between its construction and destruction to a sum, s.
class ScopedTimer {
 public:
  explicit ScopedTimer(double& sum) : sum_(sum), start_(wall_seconds()) {}
  ~ScopedTimer() { sum_ += wall_seconds() - start_; }
  ScopedTimer(const ScopedTimer&) = delete;
  ScopedTimer& operator=(const ScopedTimer&) = delete;

 private:
  double& sum_;
  double start_;
};

}  // namespace parison::core
