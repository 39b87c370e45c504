#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <string>

namespace parison::forming {

/// A text whose first line begins at column `indent` of the terminal, broken between words before column `width`; the
/// lines after the first are indented as far. Without a line feed at the end.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width = 120);

}  // namespace parison::forming
