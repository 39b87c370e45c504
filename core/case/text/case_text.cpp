// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/text/case_text.hpp"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

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

std::string quoted(const std::string& text) {
  std::string found = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      found += {'\\', c};
    else if (static_cast<unsigned char>(c) < ' ' || c == 0x7f)
      found += fmt::format("\\u{:04X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
    else
      found += c;
  }
  return found + '"';
}

namespace {

constexpr std::size_t line_width = 140;

std::string key_text(const std::string& key) {
  const auto is_bare = [](unsigned char c) { return c < 128 && (std::isalnum(c) || c == '_' || c == '-'); };
  return !key.empty() && std::all_of(key.begin(), key.end(), is_bare) ? key : quoted(key);
}

/// Names first, as a reader looks for them; the others in the order in which they are kept.
std::vector<const CaseNode*> members(const CaseNode& table) {
  std::vector<const CaseNode*> sorted;
  for (const CaseNode& item : table.items) sorted.push_back(&item);
  std::stable_partition(sorted.begin(), sorted.end(), [](const CaseNode* item) { return item->name == "name"; });
  return sorted;
}

std::string value_text(const CaseNode& node) {
  if (node.kind == CaseNode::Kind::text) return quoted(node.given.empty() ? node.text : node.given);
  if (node.kind == CaseNode::Kind::number) return fmt::format("{}", node.number);
  if (node.kind == CaseNode::Kind::flag) return node.flag ? "true" : "false";
  std::vector<std::string> parts;
  if (node.kind == CaseNode::Kind::list) {
    for (const CaseNode& item : node.items) parts.push_back(value_text(item));
    return fmt::format("[{}]", fmt::join(parts, ", "));
  }
  for (const CaseNode* item : members(node))
    parts.push_back(fmt::format("{} = {}", key_text(item->name), value_text(*item)));
  return fmt::format("{{ {} }}", fmt::join(parts, ", "));
}

bool is_table_list(const CaseNode& node) {
  const auto is_table = [](const CaseNode& item) { return item.kind == CaseNode::Kind::table; };
  return node.kind == CaseNode::Kind::list && !node.items.empty() &&
         std::all_of(node.items.begin(), node.items.end(), is_table);
}

/// `key = value`, a list with a line for each entry where it is long.
std::string line_of(const CaseNode& node) {
  const std::string line = fmt::format("{} = {}\n", key_text(node.name), value_text(node));
  if (node.kind != CaseNode::Kind::list || line.size() < line_width) return line;
  std::string text = key_text(node.name) + " = [\n";
  for (const CaseNode& item : node.items) text += "  " + value_text(item) + ",\n";
  return text + "]\n";
}

}  // namespace

std::string case_text(const CaseNode& root) {
  std::string text, tables;
  for (const CaseNode& node : root.items)
    if (node.kind == CaseNode::Kind::table) {
      tables += fmt::format("\n[{}]\n", key_text(node.name));
      for (const CaseNode* item : members(node)) tables += line_of(*item);
    } else if (is_table_list(node)) {
      for (const CaseNode& entry : node.items) {
        tables += fmt::format("\n[[{}]]\n", key_text(node.name));
        for (const CaseNode* item : members(entry)) tables += line_of(*item);
      }
    } else {
      text += line_of(node);
    }
  return text + tables;
}

}  // namespace parison::core
