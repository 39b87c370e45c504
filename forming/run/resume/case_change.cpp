// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/resume/case_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "forming/run/resume/case_differences.hpp"

namespace parison::forming {
namespace {

using core::CaseFile;
using core::CaseNode;

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
      : cases_(comparable_cases(folder_before, overrides_before, scene.file, scene.overrides)),
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
    return item_differences(before_.root, now_.root, item);
  }

  std::vector<CaseDifference> differences_of_tool(Index tool) const {
    return entry_differences(*member(before_.root, "tool"), *member(now_.root, "tool"), static_cast<std::size_t>(tool));
  }

  std::string used_of(const std::string& item) const {
    if (item == "output") return {};
    const CaseNode *old_item = member(before_.root, item), *new_item = member(now_.root, item);
    const bool are_lists =
        old_item && new_item && old_item->kind == CaseNode::Kind::list && new_item->kind == CaseNode::Kind::list;
    if (item == "tool" && are_lists && old_item->items.size() == new_item->items.size()) return used_tool();
    if (item == "dimension") return used_dimension();
    const auto found = item == "stage" && are_lists
                           ? first_entry_differences(*old_item, *new_item, static_cast<std::size_t>(stage_) + 1)
                           : differences(item);
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

  std::pair<CaseFile, CaseFile> cases_;
  const CaseFile &before_ = cases_.first, &now_ = cases_.second;
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

}  // namespace parison::forming
