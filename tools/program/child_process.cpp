// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/child_process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "core/process/run_error.hpp"

namespace parison::tools {

int start_self(const std::vector<std::string>& arguments, const std::string& log) {
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) throw core::RunError(fmt::format("{}: cannot be written: {}", log, std::strerror(errno)));
  std::vector<std::string> words = {"parison"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw core::RunError(fmt::format("no process can be started: {}", std::strerror(errno)));
  if (child == 0) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // it stops where this process is killed
    if (getppid() != parent) _exit(127);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    for (const char* name : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"}) setenv(name, "1", 1);
    execv("/proc/self/exe", argv.data());
    _exit(127);
  }
  close(file);
  return child;
}

bool has_ended(int child) {
  return waitpid(child, nullptr, WNOHANG) == child;
}

void request_stop(int child) {
  kill(child, SIGTERM);
}

}  // namespace parison::tools
