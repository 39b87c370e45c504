// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json.hpp"

#include <fmt/format.h>

#include <cmath>

namespace parison::core {

std::string json_text(const std::string& text) {
  std::string escaped = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') escaped += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20) escaped += fmt::format("\\u{:04x}", static_cast<int>(c));
    else escaped += c;
  }
  return escaped + '"';
}

JsonWriter::JsonWriter() : text_("{"), closing_("}") {}

void JsonWriter::begin(const std::string& key) {
  text_ += first_ ? "\n" : ",\n";
  text_.append(2 * closing_.size(), ' ');
  if (!key.empty()) text_ += json_text(key) + ": ";
  first_ = false;
}

void JsonWriter::open(const std::string& key, char bracket, char closing) {
  begin(key);
  text_ += bracket;
  closing_ += closing;
  first_ = true;
}

void JsonWriter::open_object(const std::string& key) { open(key, '{', '}'); }
void JsonWriter::open_list(const std::string& key) { open(key, '[', ']'); }

void JsonWriter::close() {
  const char closing = closing_.back();
  closing_.pop_back();
  if (!first_) {
    text_ += '\n';
    text_.append(2 * closing_.size(), ' ');
  }
  text_ += closing;
  first_ = false;
}

void JsonWriter::add(const std::string& key, double value) {
  begin(key);
  text_ += std::isfinite(value) ? fmt::format("{}", value) : "null";
}

void JsonWriter::add(const std::string& key, long value) {
  begin(key);
  text_ += fmt::format("{}", value);
}

void JsonWriter::add(const std::string& key, bool value) {
  begin(key);
  text_ += value ? "true" : "false";
}

void JsonWriter::add(const std::string& key, const std::string& value) {
  begin(key);
  text_ += json_text(value);
}

std::string JsonWriter::finish() {
  while (!closing_.empty()) close();
  return text_ + '\n';
}

}  // namespace parison::core
