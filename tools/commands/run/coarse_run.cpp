// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/run/coarse_run.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <thread>
#include <utility>

#include "tools/program/child_process.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

constexpr unsigned poll_microseconds = 20000;

}  // namespace

CoarseRuns::CoarseRuns(std::vector<forming::CoarseCase> cases) : cases_(std::move(cases)) {}

CoarseRuns::~CoarseRuns() {
  if (has_ended()) return;
  request_stop(child_);
  while (!has_ended()) usleep(poll_microseconds);
}

void CoarseRuns::start_next() {
  const forming::CoarseCase& next = cases_[started_++];
  std::vector<std::string> arguments = {"run",      next.file,      "--accuracy",    next.accuracy,
                                        "--output", next.directory, "--later-counts"};
  for (const std::string& assignment : next.overrides) arguments.insert(arguments.end(), {"--set", assignment});
  child_ = start_self(arguments, next.directory + ".log");
}

void CoarseRuns::step_taken(const forming::RunView&, const forming::State&, const forming::StepReport&) {
  if (started_ < cases_.size() && std::thread::hardware_concurrency() > 1 && has_ended()) start_next();
}

void CoarseRuns::wait() {
  if (started_ == 0) return;
  bool told = false, requested = false;
  for (;;) {
    if (has_ended()) {
      if (started_ == cases_.size() || stop_requested()) return;
      start_next();
    }
    if (!std::exchange(told, true)) {
      fmt::print("\nwaiting for the coarser runs of the error bars, {}.log\n", cases_[started_ - 1].directory);
      std::fflush(stdout);
    }
    if (stop_requested() && !std::exchange(requested, true)) request_stop(child_);
    usleep(poll_microseconds);
  }
}

bool CoarseRuns::has_ended() {
  if (child_ != 0 && tools::has_ended(child_)) child_ = 0;
  return child_ == 0;
}

}  // namespace parison::tools
