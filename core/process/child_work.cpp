// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/child_work.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <signal.h>
#include <sys/poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <new>

#include "core/process/clock.hpp"
#include "core/process/run_error.hpp"

namespace parison::core {
namespace {

constexpr char complete = '.';  ///< ends the text of a child that lived to the end
constexpr int out_of_memory = 10, thrown = 11;

/// Address space of this process, bytes; 0 where the system does not tell.
std::size_t address_space() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
}

void limit(decltype(RLIMIT_CORE) resource, std::size_t amount) {
  rlimit allowed{};
  if (::getrlimit(resource, &allowed) != 0) return;
  allowed.rlim_cur = std::min<rlim_t>(allowed.rlim_max, amount);
  ::setrlimit(resource, &allowed);
}

void confine(const ChildLimits& limits) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  // What the program does at a crash of its own, such as asking the user or writing a report, is not for the child.
  for (const int crash : {SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGXCPU}) ::signal(crash, SIG_DFL);
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_CPU, static_cast<std::size_t>(limits.seconds));
  limit(RLIMIT_AS, address_space() + limits.memory_bytes);
  const int nothing = ::open("/dev/null", O_RDWR);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, standard);
}

/// What the child does; its exit code.
int work_as_child(const std::function<std::string()>& work, const ChildLimits& limits, int pipe) {
  confine(limits);
  try {
    const std::string text = work() + complete;
    for (std::size_t done = 0; done < text.size();) {
      const auto written = ::write(pipe, text.data() + done, text.size() - done);
      if (written < 0 && errno != EINTR) return thrown;
      if (written > 0) done += static_cast<std::size_t>(written);
    }
    return 0;
  } catch (const std::bad_alloc&) {
    return out_of_memory;
  } catch (...) {
    return thrown;
  }
}

/// Reads until the other end is closed; false where that took longer than it may.
bool read_until_closed(int pipe, int seconds, std::string& text) {
  constexpr std::size_t longest = 100'000'000;
  const double deadline = wall_seconds() + seconds;
  char portion[1 << 14];
  for (;;) {
    const double left = deadline - wall_seconds();
    pollfd readable{pipe, POLLIN, 0};
    const int ready = left > 0 ? ::poll(&readable, 1, static_cast<int>(std::ceil(1e3 * left))) : 0;
    if (ready == 0 || text.size() > longest) return false;
    if (ready < 0) continue;  // interrupted by a signal
    const auto count = ::read(pipe, portion, sizeof portion);
    if (count == 0) return true;
    if (count > 0) text.append(portion, static_cast<std::size_t>(count));
  }
}

std::string death_of(int status, const ChildLimits& limits) {
  const std::string too_long = fmt::format("it took more than {} s", limits.seconds);
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return too_long;
  if (WIFSIGNALED(status)) return fmt::format("it was ended by \"{}\"", ::strsignal(WTERMSIG(status)));
  if (WIFEXITED(status) && WEXITSTATUS(status) == out_of_memory)
    return fmt::format("it took more than {} MB of memory", limits.memory_bytes / 1'000'000);
  return "it ended with an error";
}

}  // namespace

ChildWork in_child(const std::function<std::string()>& work, const ChildLimits& limits) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    throw SystemError(fmt::format("no process can be started: {}", std::strerror(errno)), errno);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    ::_exit(work_as_child(work, limits, ends[1]));
  }
  const int reason = errno;
  ::close(ends[1]);
  ChildWork result;
  const bool in_time = child > 0 && read_until_closed(ends[0], limits.seconds, result.text);
  ::close(ends[0]);
  if (child < 0) throw SystemError(fmt::format("no process can be started: {}", std::strerror(reason)), reason);
  if (!in_time) ::kill(child, SIGKILL);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  const bool is_complete = in_time && !result.text.empty() && result.text.back() == complete;
  if (!is_complete)
    return {"", in_time ? death_of(status, limits) : fmt::format("it took more than {} s", limits.seconds)};
  result.text.pop_back();
  return result;
}

}  // namespace parison::core
