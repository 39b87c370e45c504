#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>
#include <string>

namespace parison::core {

/// What ends a run and is neither an error of the case nor of the program: a file that the system refuses, memory that
/// does not suffice, an outline that cannot be meshed. The message is a sentence for the user.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The system refused a file or a process, as on a full disk: what failed for it can be tried again.
struct SystemError : RunError {
  int code;  ///< errno

  SystemError(const std::string& message, int its_code) : RunError(message), code(its_code) {}
};

}  // namespace parison::core
