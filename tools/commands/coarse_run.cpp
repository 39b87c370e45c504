// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/coarse_run.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <thread>
#include <utility>

#include "forming/study/coarse_run.hpp"
#include "tools/program/child_process.hpp"
#include "tools/program/stop_request.hpp"

namespace parison::tools {
namespace {

constexpr unsigned poll_microseconds = 20000;

}  // namespace

CoarseRun::CoarseRun(const forming::Scene& scene, std::string directory)
    : scene_(scene), directory_(std::move(directory)) {}

CoarseRun::~CoarseRun() {
  if (has_ended()) return;
  request_stop(child_);
  while (!has_ended()) usleep(poll_microseconds);
}

void CoarseRun::step_taken(const forming::RunView&, const forming::State&, const forming::StepReport&) {
  if (std::exchange(started_, true) || std::thread::hardware_concurrency() < 2) return;
  const forming::CoarseCase coarse_run = forming::coarse_case(scene_, directory_);
  std::vector<std::string> arguments = {"run",      coarse_run.file,     "--accuracy", coarse_run.accuracy,
                                        "--output", coarse_run.directory};
  for (const std::string& assignment : coarse_run.overrides) arguments.insert(arguments.end(), {"--set", assignment});
  child_ = start_self(arguments, coarse_run.directory + ".log");
}

void CoarseRun::wait() {
  if (has_ended()) return;
  fmt::print("\nwaiting for the coarse run of the error bars, {}\n", directory_ + "/coarse_run.log");
  std::fflush(stdout);
  for (bool requested = false; !has_ended(); usleep(poll_microseconds))
    if (stop_requested() && !std::exchange(requested, true)) request_stop(child_);
}

bool CoarseRun::has_ended() {
  if (child_ != 0 && tools::has_ended(child_)) child_ = 0;
  return child_ == 0;
}

}  // namespace parison::tools
