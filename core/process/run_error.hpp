#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

namespace parison::core {

/// What ends a run and is neither an error of the case nor of the program: a file that the system refuses, memory that
/// does not suffice, an outline that cannot be meshed. The message is a sentence for the user.
struct RunError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace parison::core
