#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <string_view>

namespace parison::core {

/// The most dots in one key, and the most brackets of values within each other, that a case may have: what reads and
/// deletes nested values takes stack for each level.
inline constexpr int max_case_depth = 16;

/// The first line of a TOML text, from 1, on which a key or a value is deeper than that; 0 where none is. Texts and
/// comments do not count. It takes a time that grows with the length and next to no memory, whatever the text is.
int too_deep_line(std::string_view text);

}  // namespace parison::core
