// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json_read.hpp"

#include <fmt/core.h>

#include <charconv>
#include <limits>
#include <stdexcept>

namespace parison::core {
namespace {

using Kind = JsonValue::Kind;

struct Parser {
  const std::string& text;
  const std::string& what;
  std::size_t at = 0;

  [[noreturn]] void refuse() const {
    throw std::runtime_error(fmt::format("{}: no JSON at character {}", what, at));
  }
  char next() {
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == text.npos) at = text.size();
    return at < text.size() ? text[at] : '\0';
  }
  void expect(char c) {
    if (next() != c) refuse();
    ++at;
  }
  bool take(const std::string& word) {
    if (text.compare(at, word.size(), word) != 0) return false;
    at += word.size();
    return true;
  }
  char escaped() {
    const char c = at < text.size() ? text[at++] : '\0';
    if (c != 'u') return c == 'n' ? '\n' : c == 't' ? '\t' : c;
    unsigned code = 0;
    if (at + 4 > text.size()) refuse();
    std::from_chars(text.data() + at, text.data() + at + 4, code, 16);
    at += 4;
    return static_cast<char>(code);  // the writer escapes control characters only
  }
  std::string quoted() {
    expect('"');
    std::string result;
    for (;;) {
      if (at >= text.size()) refuse();
      const char c = text[at++];
      if (c == '"') return result;
      result += c == '\\' ? escaped() : c;
    }
  }
  void read_items(JsonValue& value, char closing) {
    ++at;
    if (next() == closing) {
      ++at;
      return;
    }
    for (;;) {
      std::string name;
      if (closing == '}') {
        next();
        name = quoted();
        expect(':');
      }
      value.items.push_back(read());
      value.items.back().name = name;
      const char c = next();
      ++at;
      if (c == closing) return;
      if (c != ',') refuse();
    }
  }
  JsonValue read() {
    JsonValue value;
    const char c = next();
    if (c == '{' || c == '[') {
      value.kind = c == '{' ? Kind::object : Kind::list;
      read_items(value, c == '{' ? '}' : ']');
    } else if (c == '"') {
      value.kind = Kind::text;
      value.text = quoted();
    } else if (take("true") || take("false")) {
      value.kind = Kind::flag;
      value.flag = c == 't';
    } else if (!take("null")) {
      value.kind = Kind::number;
      const auto end = std::from_chars(text.data() + at, text.data() + text.size(), value.number);
      if (end.ec != std::errc{}) refuse();
      at = static_cast<std::size_t>(end.ptr - text.data());
    }
    return value;
  }
};

}  // namespace

const JsonValue* JsonValue::find(const std::string& member) const {
  for (const JsonValue& item : items)
    if (item.name == member) return &item;
  return nullptr;
}

double JsonValue::number_of(const std::string& member) const {
  const JsonValue* item = find(member);
  return item && item->kind == Kind::number ? item->number : std::numeric_limits<double>::quiet_NaN();
}

std::string JsonValue::text_of(const std::string& member) const {
  const JsonValue* item = find(member);
  return item ? item->text : "";
}

bool JsonValue::flag_of(const std::string& member) const {
  const JsonValue* item = find(member);
  return item && item->flag;
}

JsonValue read_json(const std::string& text, const std::string& what) {
  Parser parser{text, what};
  JsonValue value = parser.read();
  if (parser.next() != '\0') parser.refuse();
  return value;
}

}  // namespace parison::core
