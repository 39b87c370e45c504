#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>

namespace parison::core {

/// A mistake in a case file: `file:line: key: what was found, what is allowed`.
struct CaseError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace parison::core
