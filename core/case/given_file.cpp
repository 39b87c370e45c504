// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/given_file.hpp"

#include <fmt/core.h>

#include <filesystem>

#include "core/io/input_file.hpp"

namespace parison::core {

std::string read_given_file(const CaseNode& at, const std::string& path, const std::string& allowed) {
  std::error_code unknown;
  if (!std::filesystem::exists(path, unknown)) refuse(at, fmt::format("no file \"{}\", allowed is {}", path, allowed));
  InputFile file = read_input_file(path);
  if (!file.problem.empty()) refuse(at, fmt::format("\"{}\" {}", path, file.problem));
  return std::move(file.content);
}

Lines::Lines(std::string_view text) : rest_(text) {
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (rest_.substr(0, byte_order_mark.size()) == byte_order_mark) rest_.remove_prefix(byte_order_mark.size());
}

bool Lines::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const auto end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  ++number_;
  return true;
}

std::string_view trimmed(std::string_view text) {
  constexpr const char* blanks = " \t\r\n\v\f";
  const auto first = text.find_first_not_of(blanks);
  return first == text.npos ? std::string_view{} : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string in_small_ascii(std::string_view text) {
  std::string small(text);
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::vector<std::string_view> split(std::string_view text, char sign) {
  constexpr std::size_t most = 1000;
  std::vector<std::string_view> parts;
  for (;;) {
    const auto end = text.find(sign);
    parts.push_back(parts.size() < most ? text.substr(0, end) : text);
    if (end == text.npos || parts.size() > most) return parts;
    text.remove_prefix(end + 1);
  }
}

}  // namespace parison::core
