// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/linear/solver_times.hpp"

#include "core/process/clock.hpp"

namespace parison::core {

namespace {

thread_local SolverTimes times_of_thread;

}  // namespace

SolverTimes solver_times() {
  return times_of_thread;
}

SolverTimer::SolverTimer(Work work) : work_(work), start_(thread_cpu_seconds()) {}

SolverTimer::~SolverTimer() {
  double& sum = work_ == Work::factorisation ? times_of_thread.factorisation : times_of_thread.solution;
  sum += thread_cpu_seconds() - start_;
}

}  // namespace parison::core
