// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/case/text/case_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace parison::core {
namespace {

constexpr std::size_t line_width = 140;

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
