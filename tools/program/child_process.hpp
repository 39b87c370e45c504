#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <string>
#include <vector>

namespace parison::tools {

/// Starts this program again with other arguments, on one thread, in a process group of its own, asked to stop where
/// this process ends before it; what it prints goes to the end of a file. Returns its id.
int start_self(const std::vector<std::string>& arguments, const std::string& log);

/// Does work in a copy of this process, like start_self without the start of a program; what it returns is the exit
/// code. This process must have no other threads and have called keep_children_waiting. Returns the id of the copy.
int start_work(const std::function<int()>& work, const std::string& log);

/// Lets a process wait for the end of its children; once, before it starts any.
void keep_children_waiting();

/// A child that has ended, after waiting for one so long at most, s; 0 where none has.
int ended_child(double seconds);

/// Runs a program by its path with its arguments as they are, no shell between, its errors not shown; whether it ended
/// with 0.
bool run_program(std::vector<std::string> words);

/// Whether a child has ended.
bool has_ended(int child);

/// Asks a child to stop as a first Ctrl-C does.
void request_stop(int child);

}  // namespace parison::tools
