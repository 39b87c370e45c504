// SPDX-License-Identifier: GPL-3.0-or-later
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#define TOML_ASSERT(condition) ((void)0)  // the parser reports what it asserts
#include "core/case/text/case_edit.hpp"

#include <fmt/core.h>
#include <toml++/toml.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "core/case/given_file.hpp"
#include "core/case/text/case_text.hpp"

namespace parison::core {
namespace {

constexpr const char* byte_mark = "\xEF\xBB\xBF";  // with which some editors begin a file

[[noreturn]] void cannot(const std::string& file, const std::string& key, const std::string& why) {
  CaseNode place;
  place.file = file;
  place.key = key;
  refuse(place, why + ", allowed is to change it in the text");
}

/// The byte of a place that the parser gives by line and letter.
std::size_t byte_of(const std::string& text, const toml::source_position& place) {
  std::size_t at = text.compare(0, 3, byte_mark) == 0 ? 3 : 0;
  for (auto line = place.line; line > 1; --line) at = text.find('\n', at) + 1;
  const auto goes_on = [&] { return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80; };
  for (auto column = place.column; column > 1 && at < text.size(); --column) {
    ++at;
    while (goes_on()) ++at;
  }
  return at;
}

/// Where a value ends, without the blanks behind it that the parser counts.
std::size_t end_of(const std::string& text, const toml::node& node) {
  std::size_t end = byte_of(text, node.source().end);
  while (end > 0 && (text[end - 1] == ' ' || text[end - 1] == '\t' || text[end - 1] == '\r' || text[end - 1] == '\n'))
    --end;
  return end;
}

/// Whether a table has lines of its own, under a header or as the file; otherwise it is inline or that of dotted keys.
bool has_header(const std::string& text, const toml::table& table) {
  return !table.is_inline() && text[byte_of(text, table.source().begin)] == '[';
}

/// The last byte of the values that stand below a header, or in the file before the first one; 0 without one.
std::size_t end_of_own_values(const std::string& text, const toml::table& table) {
  std::size_t end = 0;
  for (const auto& [key, item] : table) {
    if (const auto* inner = item.as_table(); inner && !inner->is_inline()) {
      if (!has_header(text, *inner)) end = std::max(end, end_of_own_values(text, *inner));
      continue;
    }
    const auto* list = item.as_array();
    const auto* first = list && !list->empty() ? list->front().as_table() : nullptr;
    if (!first || first->is_inline()) end = std::max(end, end_of(text, item));
  }
  return end;
}

/// Puts a line behind the one in which `at` lies.
std::string with_line(const std::string& text, std::size_t at, const std::string& line) {
  const std::size_t end = text.find('\n', at);
  const std::string ending = text.find("\r\n") != text.npos ? "\r\n" : "\n";
  if (end == text.npos) return text + ending + line;
  return text.substr(0, end + 1) + line + ending + text.substr(end + 1);
}

/// Puts a key into an inline table, before its last bracket.
std::string with_member(const std::string& text, const toml::table& table, const std::string& line) {
  const std::size_t bracket = end_of(text, table) - 1;
  std::size_t at = bracket;
  while (text[at - 1] == ' ') --at;
  return text.substr(0, at) + (table.empty() ? " " : ", ") + line + " " + text.substr(bracket);
}

/// A way to a value: the tables and lists that lead to it, each with the word that leads on.
struct Way {
  std::vector<const toml::node*> nodes;
  std::vector<std::string> words;
  bool ends = false;  ///< the last node is the value itself
};

const toml::node* next_of(const toml::node& node, const std::string& word) {
  if (const auto* table = node.as_table()) return table->get(word);
  std::size_t index = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), index);
  const auto* list = node.as_array();
  return list && read.ec == std::errc() && index < list->size() ? list->get(index) : nullptr;
}

Way way_to(const toml::table& root, const std::string& numbered_key) {
  Way way{{&root}, {}};
  for (const auto word : split(numbered_key, '.')) way.words.emplace_back(word);
  for (const std::string& word : way.words) {
    const toml::node* next = next_of(*way.nodes.back(), word);
    if (!next) return way;
    way.nodes.push_back(next);
  }
  way.ends = true;
  return way;
}

/// Adds the last words of a way as a new key to the table in which it ends.
std::string with_key(const std::string& text, const Way& way, const std::string& value, const std::string& file,
                     const std::string& key) {
  std::size_t depth = way.nodes.size() - 1;
  const auto* table = way.nodes[depth]->as_table();
  if (!table) cannot(file, key, "no table was found to put it into");
  while (depth > 0 && !table->is_inline() && !has_header(text, *table)) {
    table = way.nodes[--depth]->as_table();
    if (!table) cannot(file, key, "no table was found to put it into");
  }
  std::string line;
  for (std::size_t i = depth; i < way.words.size(); ++i) line += (line.empty() ? "" : ".") + way.words[i];
  line += " = " + value;
  if (table->is_inline()) return with_member(text, *table, line);
  if (const std::size_t end = end_of_own_values(text, *table)) return with_line(text, end - 1, line);
  if (depth == 0) return line + "\n" + text;
  return with_line(text, byte_of(text, table->source().begin), line);
}

/// A value as the file is to have it: TOML as it is, all else as a text.
std::string as_toml(const std::string& value) {
  const auto parsed = find_flaw(value).line == 0 ? toml::parse("value = " + value) : toml::parse("[");
  return parsed && parsed.table().size() == 1 ? value : quoted(value);
}

bool is_same(const CaseNode& a, const CaseNode& b) {
  const bool named = a.kind == CaseNode::Kind::table;
  return a.kind == b.kind && a.text == b.text && a.number == b.number && a.flag == b.flag &&
         std::equal(a.items.begin(), a.items.end(), b.items.begin(), b.items.end(),
                    [&](const auto& x, const auto& y) { return (!named || x.name == y.name) && is_same(x, y); });
}

void sort_tables(CaseNode& node) {
  if (node.kind == CaseNode::Kind::table)
    std::sort(node.items.begin(), node.items.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  for (CaseNode& item : node.items) sort_tables(item);
}

}  // namespace

std::string edited_case_text(const std::string& text, const std::string& file, const std::string& assignment) {
  CaseFile wanted{file, ".", parse_case_text(text, file), {}};
  const CaseFile before = wanted;
  override_value(wanted, assignment);
  const std::size_t equals = assignment.find('=');
  const std::string key = numbered_key(before, assignment.substr(0, equals));
  std::string value = assignment.substr(equals + 1);
  value.erase(0, value.find_first_not_of(" \t"));
  value.erase(value.find_last_not_of(" \t") + 1);
  const auto parsed = toml::parse(std::string_view(text), std::string_view(file));
  const Way way = way_to(parsed.table(), key);
  std::string edited;
  if (way.ends) {
    const toml::node& node = *way.nodes.back();
    if (const auto* table = node.as_table(); table && !table->is_inline())
      cannot(file, key, "a table of several lines was found");
    const std::size_t begin = byte_of(text, node.source().begin), end = end_of(text, node);
    edited = text.substr(0, begin) + as_toml(value) + text.substr(end);
  } else {
    edited = with_key(text, way, as_toml(value), file, key);
  }
  CaseNode found = parse_case_text(edited, file);
  sort_tables(found);
  sort_tables(wanted.root);
  if (!is_same(found, wanted.root)) cannot(file, key, "a place was found that several values share");
  return edited;
}

namespace {

/// The node in the file with the key of an error that begins in its line, or that its key does.
const toml::node* find(const toml::node& node, const std::string& key, const CaseError& error, int line) {
  if (key == error.key && line == error.line) return &node;
  if (const auto* table = node.as_table())
    for (const auto& [name, item] : *table) {
      const std::string inner = (key.empty() ? "" : key + ".") + std::string(name.str());
      if (const auto* found = find(item, inner, error, static_cast<int>(name.source().begin.line))) return found;
    }
  if (const auto* list = node.as_array())
    for (const auto& item : *list)
      if (const auto* found = find(item, key, error, static_cast<int>(item.source().begin.line))) return found;
  return nullptr;
}

}  // namespace

TextRange range_of(const std::string& text, const CaseError& error) {
  TextRange range{error.line, 0, error.line, 0};
  if (error.line == 0 || find_flaw(text).line != 0) return range;
  const auto parsed = toml::parse(std::string_view(text));
  if (!parsed) {
    const auto& begin = parsed.error().source().begin;
    return {static_cast<int>(begin.line), static_cast<int>(begin.column), static_cast<int>(begin.line),
            static_cast<int>(begin.column)};
  }
  const toml::node* node = find(parsed.table(), "", error, error.line + 1);
  if (!node || node->as_table()) return range;
  const auto& [begin, end, path] = node->source();
  return {static_cast<int>(begin.line), static_cast<int>(begin.column), static_cast<int>(end.line),
          static_cast<int>(end.column)};
}

}  // namespace parison::core
