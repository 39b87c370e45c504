#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include "core/case/case_file.hpp"

namespace parison::forming {

/// What the case says against an assignment, without the option `--set`, which the user of a file has not given.
std::string refusal_text(const core::CaseError& error);

/// The same where the assignments were given by another option: with that option and the assignment that it is about.
/// What is about none of them is as it is.
std::string refusal_text(const core::CaseError& error, const std::string& option,
                         const std::vector<std::string>& assignments);

/// Refuses the assignment of the list `set` of a file that the error is about, at its line there; throws the error as
/// it is where it is about none of them. `set` may be null.
[[noreturn]] void refuse_setting(const core::CaseNode* set, const core::CaseError& error);

}  // namespace parison::forming
