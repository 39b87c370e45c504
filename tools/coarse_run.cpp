// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/coarse_run.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <cstdio>
#include <thread>
#include <utility>

#include "forming/study/coarse_run.hpp"
#include "tools/child_process.hpp"
#include "tools/stop_request.hpp"

namespace parison::tools {
namespace {

constexpr unsigned poll_microseconds = 20000;

}  // namespace

CompanionRun::CompanionRun(const forming::Scene& scene, std::string directory)
    : scene_(scene), directory_(std::move(directory)) {}

CompanionRun::~CompanionRun() {
  if (has_ended()) return;
  ask_to_stop(child_);
  while (!has_ended()) usleep(poll_microseconds);
}

void CompanionRun::start() {
  if (std::exchange(started_, true) || std::thread::hardware_concurrency() < 2) return;
  const forming::CompanionCase companion = forming::companion_case(scene_, directory_);
  std::vector<std::string> arguments = {"run",      companion.file,     "--accuracy", companion.accuracy,
                                        "--output", companion.directory};
  for (const std::string& assignment : companion.overrides) arguments.insert(arguments.end(), {"--set", assignment});
  child_ = start_self(arguments, companion.directory + ".log");
}

void CompanionRun::wait() {
  if (has_ended()) return;
  fmt::print("\nwaiting for the companion run of the error bars, {}\n", directory_ + "/companion.log");
  std::fflush(stdout);
  for (bool told = false; !has_ended(); usleep(poll_microseconds))
    if (stop_asked() && !std::exchange(told, true)) ask_to_stop(child_);
}

bool CompanionRun::has_ended() {
  if (child_ != 0 && tools::has_ended(child_)) child_ = 0;
  return child_ == 0;
}

}  // namespace parison::tools
