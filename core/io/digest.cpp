// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/digest.hpp"

#include <fmt/core.h>

#include "core/io/files.hpp"

namespace parison::core {
namespace {

std::string last_line(const std::string& content) {
  return fmt::format("\nlength {:016x} digest {}\n", content.size(), fingerprint_text(fingerprint(content)));
}

}  // namespace

std::string with_digest(std::string content) {
  content += last_line(content);
  return content;
}

std::optional<std::string> without_digest(std::string text) {
  const std::size_t length = last_line("").size();
  if (text.size() < length) return {};
  const std::string found = text.substr(text.size() - length);
  text.resize(text.size() - length);
  if (found != last_line(text)) return {};
  return text;
}

}  // namespace parison::core
