// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/resume/case_change.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "core/case/case_file.hpp"

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

std::string first_difference(const CaseNode& before, const CaseNode& now, const std::string& path);

std::string difference_of_tables(const CaseNode& before, const CaseNode& now, const std::string& path) {
  for (const CaseNode& item : before.items) {
    const CaseNode* other = member(now, item.name);
    const std::string found = other ? first_difference(item, *other, joined(path, item.name)) : joined(path, item.name);
    if (!found.empty()) return found;
  }
  for (const CaseNode& item : now.items)
    if (!member(before, item.name)) return joined(path, item.name);
  return {};
}

/// Of the first `count` entries, and of their number below that.
std::string difference_of_lists(const CaseNode& before, const CaseNode& now, const std::string& path,
                                std::size_t count) {
  for (std::size_t i = 0; i < std::min({count, before.items.size(), now.items.size()}); ++i) {
    const std::string found = first_difference(before.items[i], now.items[i], joined(path, label(before.items[i], i)));
    if (!found.empty()) return found;
  }
  return before.items.size() != now.items.size() && std::min(before.items.size(), now.items.size()) < count ? path : "";
}

/// Path of the first value that differs; empty where none does.
std::string first_difference(const CaseNode& before, const CaseNode& now, const std::string& path) {
  if (before.kind != now.kind) return path;
  switch (before.kind) {
    case CaseNode::Kind::table:
      return difference_of_tables(before, now, path);
    case CaseNode::Kind::list:
      return difference_of_lists(before, now, path, before.items.size() + now.items.size());
    case CaseNode::Kind::text:
      return before.text == now.text ? "" : path;
    case CaseNode::Kind::number:
      return before.number == now.number ? "" : path;
    case CaseNode::Kind::flag:
      return before.flag == now.flag ? "" : path;
  }
  return path;
}

CaseFile case_with(const std::string& path, const std::vector<std::string>& overrides) {
  CaseFile file = core::read_case_file(path);
  for (const std::string& assignment : overrides) core::override_value(file, assignment);
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
      const std::string found =
          are_stages ? difference_of_lists(*old_item, *new_item, "stage", static_cast<std::size_t>(stage) + 1)
                     : first_difference(*old_item, *new_item, item.name);
      if (!found.empty()) return found;
    }
  return changed_outline(read_scene(folder_before, scene.accuracy_name, overrides_before), scene);
}

}  // namespace parison::forming
