// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/wrapped_text.hpp"

#include <algorithm>

namespace parison::forming {
namespace {

constexpr std::size_t least = 40;  ///< characters of a line, however far it is indented

}  // namespace

std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  const std::size_t longest = std::max(least, width - std::min(width, indent));
  std::string lines;
  std::size_t from = 0;
  while (text.size() - from > longest) {
    std::size_t end = text.rfind(' ', from + longest);
    if (end == text.npos || end <= from) end = text.find(' ', from + longest);  // a word longer than a line
    if (end == text.npos) break;
    lines += text.substr(from, end - from) + '\n' + std::string(indent, ' ');
    from = end + 1;
  }
  return lines + text.substr(from);
}

}  // namespace parison::forming
