// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/resume/case_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

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

bool same_outline(const Body& a, const Body& b) {
  const auto &first = a.profile.segments, &second = b.profile.segments;
  return std::equal(first.begin(), first.end(), second.begin(), second.end(), same_segment);
}

/// Whether any text of a value contains a name as a word.
bool mentions(const CaseNode& node, const std::string& name) {
  const auto is_letter = [&](std::size_t i) {
    return i < node.text.size() && (std::isalnum(static_cast<unsigned char>(node.text[i])) || node.text[i] == '_');
  };
  for (std::size_t at = node.text.find(name); at != std::string::npos; at = node.text.find(name, at + 1))
    if (!(at > 0 && is_letter(at - 1)) && !is_letter(at + name.size())) return true;
  return std::any_of(node.items.begin(), node.items.end(), [&](const CaseNode& item) { return mentions(item, name); });
}

/// A case and a changed one, before a run that stands in a stage.
class Change {
 public:
  Change(const std::string& folder_before, const std::vector<std::string>& overrides_before, const Scene& scene,
         Index stage)
      : before_(case_with(folder_before, overrides_before)),
        now_(case_with(scene.file, scene.overrides)),
        scene_before_(read_scene(folder_before, scene.accuracy_name, overrides_before)),
        scene_(scene),
        stage_(stage) {}

  /// The first key in which the cases differ, of those that the run has used; empty where there is none.
  std::string used() const {
    for (const auto* file : {&before_, &now_})
      for (const CaseNode& item : file->root.items)
        if (const std::string key = used_of(item.name); !key.empty()) return key;
    for (Index body = 0; body <= tool_count(); ++body)
      if (!is_unused_tool(body - 1) && !same_outline(body_of(scene_before_, body), body_of(scene_, body)))
        return fmt::format("the outline of {}", body_of(scene_, body).name);
    return {};
  }

  /// The tools that no stage has used yet and that are others now.
  std::vector<Index> changed_tools() const {
    std::vector<Index> tools;
    const bool same_dimensions = differences("dimension").empty();
    for (Index tool = 0; tool < tool_count(); ++tool)
      if (is_unused_tool(tool) && (!same_dimensions || !differences_of_tool(tool).empty() ||
                                   !same_outline(scene_before_.tools[tool], scene_.tools[tool])))
        tools.push_back(tool);
    return tools;
  }

 private:
  Index tool_count() const { return static_cast<Index>(std::min(scene_before_.tools.size(), scene_.tools.size())); }
  bool is_unused_tool(Index tool) const { return tool >= 0 && first_use(scene_, tool) > stage_; }

  std::vector<CaseDifference> differences(const std::string& item) const {
    const CaseNode *old_item = member(before_.root, item), *new_item = member(now_.root, item);
    std::vector<CaseDifference> found;
    if (old_item && new_item)
      add_differences(*old_item, *new_item, item, found);
    else if (old_item || new_item)
      found.push_back({item, old_item ? shown(*old_item) : "", new_item ? shown(*new_item) : ""});
    return found;
  }

  std::vector<CaseDifference> differences_of_tool(Index tool) const {
    const auto number = static_cast<std::size_t>(tool);
    const CaseNode &old_tool = member(before_.root, "tool")->items[number],
                   &new_tool = member(now_.root, "tool")->items[number];
    std::vector<CaseDifference> found;
    add_differences(old_tool, new_tool, joined("tool", label(old_tool, number)), found);
    return found;
  }

  std::string used_of(const std::string& item) const {
    if (item == "output") return {};
    const CaseNode *old_item = member(before_.root, item), *new_item = member(now_.root, item);
    const bool are_lists =
        old_item && new_item && old_item->kind == CaseNode::Kind::list && new_item->kind == CaseNode::Kind::list;
    if (item == "tool" && are_lists && old_item->items.size() == new_item->items.size()) return used_tool();
    if (item == "dimension") return used_dimension();
    std::vector<CaseDifference> found;
    if (item == "stage" && are_lists)
      add_list_differences(*old_item, *new_item, item, static_cast<std::size_t>(stage_) + 1, found);
    else
      found = differences(item);
    return found.empty() ? std::string() : found.front().key;
  }

  /// A tool may be another one as long as it has not been used, by the same name.
  std::string used_tool() const {
    for (Index tool = 0; tool < tool_count(); ++tool) {
      if (is_unused_tool(tool) && scene_before_.tools[tool].name == scene_.tools[tool].name) continue;
      if (const auto found = differences_of_tool(tool); !found.empty()) return found.front().key;
    }
    return {};
  }

  /// A dimension may be another one where only such tools, later stages and output name it, and no other dimension.
  std::string used_dimension() const {
    for (const CaseDifference& difference : differences("dimension"))
      if (const std::string name = difference.key.substr(difference.key.find('.') + 1); is_used(name))
        return difference.key;
    return {};
  }

  bool is_used(const std::string& dimension) const {
    for (const CaseNode& item : now_.root.items) {
      const bool is_list = item.kind == CaseNode::Kind::list;
      if (item.name == "output") continue;
      for (std::size_t i = 0; i < item.items.size(); ++i) {
        if (item.name == "tool" && is_list && is_unused_tool(static_cast<Index>(i))) continue;
        if (item.name == "stage" && is_list && static_cast<Index>(i) > stage_) continue;
        if (mentions(item.items[i], dimension)) return true;
      }
      if (item.items.empty() && mentions(item, dimension)) return true;
    }
    return false;
  }

  CaseFile before_, now_;
  Scene scene_before_;
  const Scene& scene_;
  Index stage_;
};

}  // namespace

std::string used_change(const std::string& folder_before, const std::vector<std::string>& overrides_before,
                        const Scene& scene, Index stage) {
  return Change(folder_before, overrides_before, scene, stage).used();
}

std::vector<Index> changed_unused_tools(const std::string& folder_before,
                                        const std::vector<std::string>& overrides_before, const Scene& scene,
                                        Index stage) {
  return Change(folder_before, overrides_before, scene, stage).changed_tools();
}

std::vector<CaseDifference> case_differences(const std::string& before,
                                             const std::vector<std::string>& overrides_before, const std::string& now,
                                             const std::vector<std::string>& overrides_now) {
  std::vector<CaseDifference> found;
  add_differences(case_with(before, overrides_before).root, case_with(now, overrides_now).root, "", found);
  return found;
}

}  // namespace parison::forming
