// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/resume/case_differences.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/case/case_file.hpp"
#include "core/case/tolerance.hpp"
#include "forming/scene/materials/material_library.hpp"

namespace parison::forming {

using core::CaseFile;
using core::CaseNode;

namespace {

/// An entry of a list by its own name, or its number.
std::string label(const CaseNode& entry, std::size_t number) {
  const CaseNode* name = member(entry, "name");
  return name ? name->text : fmt::format("{}", number);
}

std::string joined(const std::string& path, const std::string& word) {
  return path.empty() ? word : path + '.' + word;
}

constexpr std::size_t longest_value = 60;  ///< characters that are shown of a value

/// A value as a user reads it, the middle of a long one left out.
std::string shown(const CaseNode& node) {
  std::vector<std::string> items;
  for (const CaseNode& item : node.items)
    items.push_back(node.kind == CaseNode::Kind::table ? item.name + " = " + shown(item) : shown(item));
  std::string text = node.kind == CaseNode::Kind::table    ? fmt::format("{{ {} }}", fmt::join(items, ", "))
                     : node.kind == CaseNode::Kind::list   ? fmt::format("[{}]", fmt::join(items, ", "))
                     : node.kind == CaseNode::Kind::number ? fmt::format("{:g}", node.number)
                     : node.kind == CaseNode::Kind::flag   ? fmt::format("{}", node.flag)
                                                           : node.text;
  if (text.size() > longest_value) text = text.substr(0, longest_value / 2) + " ... " + text.substr(text.size() - 20);
  return text;
}

void add_differences(const CaseNode& before, const CaseNode& now, const std::string& path,
                     std::vector<CaseDifference>& found);

void add_table_differences(const CaseNode& before, const CaseNode& now, const std::string& path,
                           std::vector<CaseDifference>& found) {
  for (const CaseNode& item : before.items) {
    if (const CaseNode* other = member(now, item.name))
      add_differences(item, *other, joined(path, item.name), found);
    else
      found.push_back({joined(path, item.name), shown(item), ""});
  }
  for (const CaseNode& item : now.items)
    if (!member(before, item.name)) found.push_back({joined(path, item.name), "", shown(item)});
}

/// Of the first `count` entries, and of their number below that.
void add_list_differences(const CaseNode& before, const CaseNode& now, const std::string& path, std::size_t count,
                          std::vector<CaseDifference>& found) {
  const bool same_length = before.items.size() == now.items.size();
  const std::size_t shorter = std::min(before.items.size(), now.items.size());
  const bool are_tables = shorter > 0 && before.items.front().kind == CaseNode::Kind::table;
  if (!same_length && !are_tables && shorter < count) return found.push_back({path, shown(before), shown(now)});
  for (std::size_t i = 0; i < std::min(count, shorter); ++i)
    add_differences(before.items[i], now.items[i], joined(path, label(before.items[i], i)), found);
  if (!same_length && are_tables && shorter < count)
    found.push_back(
        {path, fmt::format("{} entries", before.items.size()), fmt::format("{} entries", now.items.size())});
}

/// The paths and values of all that differs.
void add_differences(const CaseNode& before, const CaseNode& now, const std::string& path,
                     std::vector<CaseDifference>& found) {
  using Kind = CaseNode::Kind;
  if (before.kind == now.kind && before.kind == Kind::table) return add_table_differences(before, now, path, found);
  if (before.kind == now.kind && before.kind == Kind::list)
    return add_list_differences(before, now, path, before.items.size() + now.items.size(), found);
  const bool same =
      before.kind == now.kind && before.text == now.text && before.number == now.number && before.flag == now.flag;
  if (!same) found.push_back({path, shown(before), shown(now)});
}

}  // namespace

std::pair<CaseFile, CaseFile> comparable_cases(const std::string& before,
                                               const std::vector<std::string>& overrides_before, const std::string& now,
                                               const std::vector<std::string>& overrides_now) {
  std::pair<CaseFile, CaseFile> cases{read_case(before, overrides_before), read_case(now, overrides_now)};
  share_materials(cases.first, cases.second);
  core::take_tolerances(cases.first);
  core::take_tolerances(cases.second);
  return cases;
}

std::vector<CaseDifference> item_differences(const CaseNode& before, const CaseNode& now, const std::string& item) {
  const CaseNode *old_item = member(before, item), *new_item = member(now, item);
  std::vector<CaseDifference> found;
  if (old_item && new_item)
    add_differences(*old_item, *new_item, item, found);
  else if (old_item || new_item)
    found.push_back({item, old_item ? shown(*old_item) : "", new_item ? shown(*new_item) : ""});
  return found;
}

std::vector<CaseDifference> entry_differences(const CaseNode& before, const CaseNode& now, std::size_t number) {
  std::vector<CaseDifference> found;
  add_differences(before.items[number], now.items[number], joined(before.name, label(before.items[number], number)),
                  found);
  return found;
}

std::vector<CaseDifference> first_entry_differences(const CaseNode& before, const CaseNode& now, std::size_t count) {
  std::vector<CaseDifference> found;
  add_list_differences(before, now, before.name, count, found);
  return found;
}

std::vector<CaseDifference> case_differences(const std::string& before,
                                             const std::vector<std::string>& overrides_before, const std::string& now,
                                             const std::vector<std::string>& overrides_now) {
  std::vector<CaseDifference> found;
  const auto [one, other] = comparable_cases(before, overrides_before, now, overrides_now);
  add_differences(one.root, other.root, "", found);
  return found;
}

}  // namespace parison::forming
