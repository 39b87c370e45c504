#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

namespace parison::core {

/// The identity that the linker gave the program, or the module of Python, that this function is part of, as hex
/// digits: another one where anything in it was built otherwise. Empty where it has none.
const std::string& build_id();

}  // namespace parison::core
