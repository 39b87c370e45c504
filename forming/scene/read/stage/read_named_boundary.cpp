// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;

void refuse_known_name(const CaseNode& node, const Scene& scene) {
  const std::string& name = core::identifier(node);
  const auto exists = [&](const Boundary& boundary) { return boundary.name == name; };
  if (std::any_of(scene.glass.boundaries.begin(), scene.glass.boundaries.end(), exists))
    core::refuse(node, fmt::format("\"{}\" is a boundary of the glass already, allowed is a new name", name));
  for (const auto& earlier : scene.stages)
    for (const auto& other : earlier.named_boundaries)
      if (other.name == name)
        core::refuse(node, fmt::format("stage \"{}\" names \"{}\" already, allowed is a new name", earlier.name, name));
}

/// The tool that made the boundary: one of the stage before.
Index read_touched(const CaseNode& node, const Scene& scene) {
  std::vector<std::string> before;
  if (!scene.stages.empty())
    for (const StageTool& tool : scene.stages.back().tools) before.push_back(scene.tools[tool.tool].name);
  if (before.empty()) core::refuse(node, "no tool is active in the stage before, allowed is \"from\" with \"to\"");
  return scene.stages.back().tools[static_cast<std::size_t>(core::choice(node, before))].tool;
}

/// The tools that were active before a stage and are not in it; those that moved alone where there are any.
std::vector<Index> tools_that_left(const Scene& scene, const Stage& stage) {
  std::vector<Index> left, moved;
  for (Index tool = 0; tool < static_cast<Index>(scene.tools.size()); ++tool) {
    const auto was_there = [&](const Stage& earlier) { return earlier.uses(tool); };
    if (stage.uses(tool) || std::none_of(scene.stages.begin(), scene.stages.end(), was_there)) continue;
    left.push_back(tool);
    if (has_moved_before(scene, static_cast<Index>(scene.stages.size()), tool)) moved.push_back(tool);
  }
  return moved.empty() ? left : moved;
}

bool names_inner_side(const Stage& stage) {
  const auto& named = stage.named_boundaries;
  return std::any_of(named.begin(), named.end(), [](const NamedBoundary& one) { return one.name == inner_side; });
}

bool knows_inner_side(const Scene& scene, const Stage& stage) {
  const auto& given = scene.glass.boundaries;
  return names_inner_side(stage) || std::any_of(scene.stages.begin(), scene.stages.end(), names_inner_side) ||
         std::any_of(given.begin(), given.end(), [](const Boundary& one) { return one.name == inner_side; });
}

}  // namespace

void read_named_boundaries(const CaseTable& table, const Scene& scene, Stage& stage) {
  refuse_repeated_names(table.tables("name_boundary"));
  for (const auto* node : table.tables("name_boundary")) {
    const CaseTable named(*node, {"name", "touched", "from", "to"});
    refuse_known_name(named.get("name"), scene);
    NamedBoundary boundary{named.get("name").text};
    if (const auto* touched = named.find("touched")) {
      for (const char* end : {"from", "to"})
        if (const auto* point = named.find(end))
          core::refuse(*point, "a point and \"touched\" were found, allowed is one of them");
      boundary.touched = read_touched(*touched, scene);
    } else {
      boundary.from = read_point(named.get("from"));
      boundary.to = read_point(named.get("to"));
    }
    stage.named_boundaries.push_back(boundary);
  }
}

void name_inner_side(const CaseNode& load, Scene& scene, Stage& stage) {
  if (knows_inner_side(scene, stage)) return;
  const std::vector<Index> left = tools_that_left(scene, stage);
  if (left.empty()) return;
  if (left.size() > 1) {
    std::vector<std::string> names;
    names.reserve(left.size());
    for (const Index tool : left) names.push_back(scene.tools[tool].name);
    core::refuse(load, fmt::format("several tools may have made the inner side ({}), allowed is to say which: "
                                   "name_boundary = [{{ name = \"inner\", touched = \"{}\" }}] in the stage after it",
                                   fmt::join(names, ", "), names.front()));
  }
  std::size_t after = scene.stages.size();
  while (!scene.stages[after - 1].uses(left.front())) --after;
  NamedBoundary inner{inner_side};
  inner.touched = left.front();
  (after == scene.stages.size() ? stage : scene.stages[after]).named_boundaries.push_back(inner);
}

void refuse_unknown_inner_side(const CaseNode& node, const Scene& scene, const Stage& stage) {
  if (!knows_inner_side(scene, stage))
    core::refuse(
        node,
        "the glass has no inner side up to this stage, allowed where a plunger or a pin has left it or a stage "
        "names a boundary \"inner\"");
}

}  // namespace parison::forming
