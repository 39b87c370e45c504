// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/stop_request.hpp"

#include <signal.h>

#include <csignal>
#include <ctime>
#include <initializer_list>

namespace parison::tools {
namespace {

volatile std::sig_atomic_t asked = 0;
volatile std::time_t asked_at = 0;

constexpr std::time_t grace =
    2;  ///< s: what follows a signal so soon belongs to it, as from `timeout`, which sends two

void take(int signal) {
  const std::time_t now = std::time(nullptr);  // safe in a handler
  if (asked && now - asked_at >= grace) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  if (!asked) asked_at = now;
  asked = 1;
}

}  // namespace

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = take;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_asked() {
  return asked != 0;
}

}  // namespace parison::tools
