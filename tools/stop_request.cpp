// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/stop_request.hpp"

#include <signal.h>

#include <csignal>
#include <initializer_list>

namespace parison::tools {
namespace {

volatile std::sig_atomic_t asked = 0;

}  // namespace

void catch_signals() {
  struct sigaction action {};
  action.sa_handler = [](int) { asked = 1; };
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM}) sigaction(signal, &action, nullptr);
  std::signal(SIGXFSZ, SIG_IGN);
}

bool stop_asked() { return asked != 0; }

}  // namespace parison::tools
