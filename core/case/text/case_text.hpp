#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <string_view>
#include <vector>

#include "core/case/case_file.hpp"

namespace parison::core {

/// The most dots in one key, and the most brackets of values within each other, that a case may have: what reads and
/// deletes nested values takes stack for each level.
inline constexpr int max_case_depth = 16;

/// What in a TOML text must not reach the parser.
struct CaseFlaw {
  int line = 0;         ///< from 1; 0 where nothing was found
  std::string problem;  ///< "..., allowed is ..."
};

/// The first key or value that is deeper than that, or sign outside texts and comments that is not ASCII, which TOML
/// does not allow and on some of which the parser has no defined behaviour. It takes a time that grows with the length
/// and next to no memory, whatever the text is.
CaseFlaw find_flaw(std::string_view text);

/// The value that a key, as override_value takes it, has in a case; an empty table where it has none and may have one.
/// Refuses a key that no value of the case leads to.
CaseNode value_of(CaseFile file, const std::string& key);

/// A key as override_value takes it with the entries of lists by their numbers, the same for each way to write it.
/// Refuses one that no value of the case leads to.
std::string numbered_key(CaseFile file, const std::string& key);

/// Of assignments as override_value takes them, one that leaves nothing of an earlier one, however the keys are
/// written, or of what it is in: both keys, as the begin of a sentence; empty where each counts.
std::string repeated_key(CaseFile file, const std::vector<std::string>& assignments);

/// A text as TOML has it, in quotes.
std::string quoted(const std::string& text);

/// The values below a table as TOML that reads back as the same case; comments and layout are its own.
std::string case_text(const CaseNode& root);

}  // namespace parison::core
