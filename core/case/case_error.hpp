#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <stdexcept>
#include <string>
#include <utility>

namespace parison::core {

/// A mistake in a case file: `file:line: key: what was found, what is allowed`, and where it is, as far as it is known.
struct CaseError : std::runtime_error {
  std::string file, key;
  int line = 0;

  using std::runtime_error::runtime_error;
  CaseError(const std::string& message, std::string its_file, int its_line, std::string its_key)
      : std::runtime_error(message), file(std::move(its_file)), key(std::move(its_key)), line(its_line) {}
};

}  // namespace parison::core
