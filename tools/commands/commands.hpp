#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/App.hpp>
#include <functional>

namespace parison::tools {

/// A command with its options; returns the exit code.
using Command = std::function<int()>;

/// Adds all commands of `parison` with their options; parsing the command line puts the one that is asked for into
/// `chosen`.
void add_commands(CLI::App& app, Command& chosen);

/// Refuses a first word that is neither an option nor a command, with the commands there are.
void check_command(const CLI::App& app, int argc, const char* const* argv);

}  // namespace parison::tools
