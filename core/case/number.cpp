// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/number.hpp"

#include <cmath>

#include "core/case/given_file.hpp"

namespace parison::core {

std::optional<LeadingNumber> leading_number(std::string_view text) {
  double value = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec != std::errc{} || !std::isfinite(value)) return {};
  return LeadingNumber{value, trimmed(text.substr(static_cast<std::size_t>(read.ptr - text.data())))};
}

}  // namespace parison::core
