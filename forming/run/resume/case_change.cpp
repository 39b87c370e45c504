// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/resume/case_change.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/case/case_file.hpp"
#include "core/case/tolerance.hpp"

namespace parison::forming {
namespace {

using core::CaseFile;
using core::CaseNode;

const CaseNode* member(const CaseNode& table, const std::string& name) {
  for (const CaseNode& item : table.items)
    if (item.name == name) return &item;
  return nullptr;
}

/// An entry of a list by its own name, or its number.
std::string label(const CaseNode& entry, std::size_t number) {
  const CaseNode* name = entry.kind == CaseNode::Kind::table ? member(entry, "name") : nullptr;
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

/// A case without its tolerances, which no run uses.
CaseFile case_with(const std::string& path, const std::vector<std::string>& overrides) {
  CaseFile file = core::read_case_file(path);
  for (const std::string& assignment : overrides) core::override_value(file, assignment);
  core::take_tolerances(file);
  return file;
}

bool same_segment(const core::Segment& a, const core::Segment& b) {
  return a.start == b.start && a.end == b.end && a.is_arc == b.is_arc && a.centre == b.centre && a.radius == b.radius &&
         a.boundary_id == b.boundary_id;
}

/// The first body whose outline differs, which a drawing may have changed.
std::string changed_outline(const Scene& before, const Scene& now) {
  for (Index body = 0; body <= static_cast<Index>(now.tools.size()); ++body) {
    const auto &old_segments = body_of(before, body).profile.segments, &segments = body_of(now, body).profile.segments;
    if (!std::equal(old_segments.begin(), old_segments.end(), segments.begin(), segments.end(), same_segment))
      return fmt::format("the outline of {}", body_of(now, body).name);
  }
  return {};
}

}  // namespace

std::string used_change(const std::string& folder_before, const std::vector<std::string>& overrides_before,
                        const Scene& scene, Index stage) {
  const CaseFile before = case_with(folder_before, overrides_before), now = case_with(scene.file, scene.overrides);
  for (const auto* file : {&before, &now})
    for (const CaseNode& item : file->root.items) {
      const CaseNode *old_item = member(before.root, item.name), *new_item = member(now.root, item.name);
      if (item.name == "output") continue;
      if (!old_item || !new_item) return item.name;
      const bool are_stages =
          item.name == "stage" && old_item->kind == CaseNode::Kind::list && new_item->kind == CaseNode::Kind::list;
      std::vector<CaseDifference> found;
      if (are_stages)
        add_list_differences(*old_item, *new_item, "stage", static_cast<std::size_t>(stage) + 1, found);
      else
        add_differences(*old_item, *new_item, item.name, found);
      if (!found.empty()) return found.front().key;
    }
  return changed_outline(read_scene(folder_before, scene.accuracy_name, overrides_before), scene);
}

std::vector<CaseDifference> case_differences(const std::string& before,
                                             const std::vector<std::string>& overrides_before, const std::string& now,
                                             const std::vector<std::string>& overrides_now) {
  std::vector<CaseDifference> found;
  add_differences(case_with(before, overrides_before).root, case_with(now, overrides_now).root, "", found);
  return found;
}

}  // namespace parison::forming
