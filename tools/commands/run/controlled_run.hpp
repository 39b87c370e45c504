#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/run/run_command.hpp"

namespace parison::tools {

/// Runs a case into a new folder as often as it takes for the accuracy that is asked for as a share, ever finer. The
/// folder keeps the last run. Returns the exit code of the program.
int run_to_accuracy(RunRequest request, double target);

}  // namespace parison::tools
