// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/stop_request.hpp"

#include <signal.h>

#include <csignal>
#include <ctime>
#include <initializer_list>

namespace parison::tools {
namespace {

volatile std::sig_atomic_t requested = 0;
volatile std::time_t requested_at = 0;

constexpr std::time_t grace =
    2;  ///< s: what follows a signal so soon belongs to it, as from `timeout`, which sends two

void handle_signal(int signal) {
  const std::time_t now = std::time(nullptr);  // safe in a handler
  if (requested && now - requested_at >= grace) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  if (!requested) requested_at = now;
  requested = 1;
}

}  // namespace

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = handle_signal;
  action.sa_flags = SA_RESTART;
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_requested() {
  return requested != 0;
}

}  // namespace parison::tools
