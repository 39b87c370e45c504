// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/text/case_depth.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace parison::core {
namespace {

/// Where the quotes end that close a text at `at`; two more may stand before those of a text of several lines.
std::size_t end_of_quotes(std::string_view rest, std::size_t at, bool of_lines) {
  const std::size_t most = at + (of_lines ? 5 : 1);
  std::size_t end = at;
  while (end < std::min(most, rest.size()) && rest[end] == rest[at]) ++end;
  return end;
}

/// The length of the quoted text or comment that `rest` begins with, 0 where it begins with neither.
std::size_t quoted_length(std::string_view rest) {
  if (rest.front() == '#') return std::min(rest.find('\n'), rest.size());
  const char quote = rest.front();
  if (quote != '"' && quote != '\'') return 0;
  const bool of_lines = rest.size() > 2 && rest[1] == quote && rest[2] == quote;
  const std::string_view end = rest.substr(0, of_lines ? 3 : 1);
  for (std::size_t at = end.size(); at < rest.size(); ++at) {
    if (quote == '"' && rest[at] == '\\')
      ++at;
    else if (rest.substr(at, end.size()) == end)
      return end_of_quotes(rest, at, of_lines);
    else if (!of_lines && rest[at] == '\n')
      return at;
  }
  return rest.size();
}

/// What belongs to a key beside its dots: a key ends at any other sign.
bool continues_key(char c) {
  return c == ' ' || c == '\t' || c == '_' || c == '-' || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
         (c >= 'a' && c <= 'z');
}

}  // namespace

CaseFlaw find_flaw(std::string_view text) {
  const std::string_view mark = "\xEF\xBB\xBF";  // with which some editors begin a file
  if (text.substr(0, mark.size()) == mark) text.remove_prefix(mark.size());
  int line = 1, dots = 0, brackets = 0;
  while (!text.empty()) {
    const std::size_t quoted = quoted_length(text), taken = std::max<std::size_t>(quoted, 1);
    const char c = text.front();
    if (quoted == 0) {
      brackets += (c == '[' || c == '{') - (c == ']' || c == '}');
      dots = c == '.' ? dots + 1 : continues_key(c) ? dots : 0;
      if (dots > max_case_depth || brackets > max_case_depth)
        return {line, fmt::format("keys or values within each other were found, deeper than {} levels, allowed are so "
                                  "many",
                                  max_case_depth)};
      if (static_cast<unsigned char>(c) >= 128)
        return {line, "a sign that is not ASCII was found outside texts and comments, allowed is TOML"};
    }
    line += static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(taken), '\n'));
    text.remove_prefix(taken);
  }
  return {};
}

}  // namespace parison::core
