#pragma once
// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <optional>
#include <string_view>

namespace parison::core {

/// A whole text as a number; nothing where it is none or too large for one. Blanks and a plus sign are no part of one,
/// "nan" and "inf" are.
template <typename Number>
std::optional<Number> parse_number(std::string_view text) {
  Number value{};
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec != std::errc{} || read.ptr != end) return {};
  return value;
}

/// The number that a text begins with, such as 440 of "440 degC".
struct LeadingNumber {
  double value;
  std::string_view rest;  ///< behind it, without the blanks at its ends
};
/// Nothing where a text does not begin with a finite number.
std::optional<LeadingNumber> leading_number(std::string_view text);

}  // namespace parison::core
