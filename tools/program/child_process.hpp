#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>
#include <vector>

namespace parison::tools {

/// Between two looks at whether a process has ended.
inline constexpr unsigned poll_microseconds = 20000;

/// Starts this program again with other arguments, on one thread, in a process group of its own, asked to stop where
/// this process ends before it; what it prints goes to the end of a file. Returns its id.
int start_self(const std::vector<std::string>& arguments, const std::string& log);

/// Does work in a copy of this process, like start_self without the start of a program; what it returns is the exit
/// code. This process must have no other threads and have called expect_children. Returns the id of the copy.
int start_work(const std::function<int()>& work, const std::string& log);

/// Holds back the signal of their end (SIGCHLD), for which await_end_of_child waits; once, before the first start_work.
void expect_children();

/// Waits for the end of any child, so long at most, s; at once where one has ended since the last wait.
void await_end_of_child(double seconds);

/// Runs a program by its path with its arguments as they are, no shell between, its errors not shown; whether it ended
/// with 0.
bool run_program(std::vector<std::string> words);

/// What a program printed, its errors included, and its exit code.
struct ProgramOutput {
  std::string text;
  int code;  ///< 127 where there is no such program, -1 where a signal ended it
};
/// Runs a program that the shell would find, without a shell between, and waits for its end.
ProgramOutput output_of_program(std::vector<std::string> words);

/// Opens an address in the browser of the user, who sees nothing where there is none.
void open_in_browser(const std::string& address);

/// Whether a child has ended.
bool has_ended(int child);

/// Asks a child to stop as a first Ctrl-C does.
void request_stop(int child);

}  // namespace parison::tools
