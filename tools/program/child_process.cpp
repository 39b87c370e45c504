// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/program/child_process.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "core/io/written_files.hpp"
#include "core/process/run_error.hpp"

namespace parison::tools {
namespace {

[[noreturn]] void fail(const std::string& message) {
  throw core::SystemError(message, errno);
}

/// Pointers to the words as exec takes them; they live as long as the words.
std::vector<char*> as_arguments(std::vector<std::string>& words) {
  std::vector<char*> arguments;
  arguments.reserve(words.size() + 1);
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  return arguments;
}

/// Does something in a copy of this process that ends with the code which that gives.
template <typename Work>
int start_child(const std::string& log, const Work& work) {
  core::require_own(log);
  core::note_growing(log);
  const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) fail(fmt::format("{}: cannot be written: {}", log, std::strerror(errno)));
  std::fflush(nullptr);
  const pid_t parent = getpid(), child = fork();
  if (child < 0) fail(fmt::format("no process can be started: {}", std::strerror(errno)));
  if (child == 0) {
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);  // it stops where this process is killed
    if (getppid() != parent) _exit(127);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    _exit(work());
  }
  close(file);
  return child;
}

sigset_t end_of_child() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGCHLD);
  return signals;
}

}  // namespace

bool run_program(std::vector<std::string> words) {
  const std::vector<char*> arguments = as_arguments(words);
  const pid_t child = fork();
  if (child < 0) return false;
  if (child == 0) {
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

ProgramOutput output_of_program(std::vector<std::string> words) {
  const std::vector<char*> arguments = as_arguments(words);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail(fmt::format("no pipe can be made: {}", std::strerror(errno)));
  const pid_t child = fork();
  if (child < 0) fail(fmt::format("no process can be started: {}", std::strerror(errno)));
  if (child == 0) {
    setpgid(0, 0);  // Ctrl-C is for this program
    dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
    dup2(ends[1], STDOUT_FILENO);
    dup2(ends[1], STDERR_FILENO);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  close(ends[1]);
  ProgramOutput output{"", -1};
  char part[4096];
  for (ssize_t count = 0; (count = read(ends[0], part, sizeof part)) != 0;)
    if (count > 0)
      output.text.append(part, static_cast<std::size_t>(count));
    else if (errno != EINTR)
      break;
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return output;
  if (WIFEXITED(status)) output.code = WEXITSTATUS(status);
  return output;
}

void open_in_browser(const std::string& address) {
  std::vector<std::string> words = {"xdg-open", address};
  const std::vector<char*> arguments = as_arguments(words);
  const pid_t child = fork();
  if (child == 0) {
    if (fork() != 0) _exit(0);  // what goes on belongs to nobody
    setsid();
    const int nowhere = open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  if (child > 0) waitpid(child, nullptr, 0);
}

int start_self(const std::vector<std::string>& arguments, const std::string& log) {
  std::vector<std::string> words = {"parison"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const std::vector<char*> argv = as_arguments(words);
  return start_child(log, [&] {
    for (const char* name : {"OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"}) setenv(name, "1", 1);
    execv("/proc/self/exe", argv.data());
    return 127;
  });
}

int start_work(const std::function<int()>& work, const std::string& log) {
  return start_child(log, [&] {
    const sigset_t ends = end_of_child();
    sigprocmask(SIG_UNBLOCK, &ends, nullptr);
    const int code = work();
    std::fflush(nullptr);
    return code;
  });
}

void expect_children() {
  const sigset_t ends = end_of_child();
  sigprocmask(SIG_BLOCK, &ends, nullptr);
}

void await_end_of_child(double seconds) {
  const sigset_t ends = end_of_child();
  const auto whole = static_cast<time_t>(seconds);
  const timespec wait{whole, static_cast<long>(1e9 * (seconds - static_cast<double>(whole)))};
  sigtimedwait(&ends, nullptr, &wait);
}

bool has_ended(int child) {
  return waitpid(child, nullptr, WNOHANG) == child;
}

void request_stop(int child) {
  kill(child, SIGTERM);
}

}  // namespace parison::tools
