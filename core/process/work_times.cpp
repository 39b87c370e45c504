// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/work_times.hpp"

#include "core/process/clock.hpp"

namespace parison::core {

namespace {

thread_local WorkTimes times_of_thread;

}  // namespace

WorkTimes work_times() {
  return times_of_thread;
}

WorkTimer::WorkTimer(double WorkTimes::*work) : work_(work), start_(wall_seconds()) {}

WorkTimer::~WorkTimer() {
  times_of_thread.*work_ += wall_seconds() - start_;
}

}  // namespace parison::core
