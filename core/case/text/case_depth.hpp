#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <string_view>

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

}  // namespace parison::core
