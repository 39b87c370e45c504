// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

Air read_air(const CaseNode& node) {
  const CaseTable table(node, {"temperature", "h", "ambient"});
  Air air;
  air.h = core::not_negative_over_time(table.get("h"), dimension::conductance);
  air.air_temperature = core::quantity_over_time(table.get("temperature"), dimension::temperature);
  air.ambient_temperature = core::quantity_over_time(table.get("ambient"), dimension::temperature);
  return air;
}

/// None where the cavities are vented.
std::optional<TrappedAirLaw> read_trapped_air(const CaseNode& node) {
  const CaseTable table(node, {"law", "temperature", "ambient", "vent_area", "seal_gap"});
  const auto& law = table.get("law");
  const Index which = core::choice(law, {"vented", "isothermal", "adiabatic"});
  if (which == 0) {
    for (const auto* key : {"temperature", "ambient", "vent_area", "seal_gap"})
      if (const auto* item = table.find(key))
        core::refuse(*item, "found with the law \"vented\", allowed with \"isothermal\" and \"adiabatic\"");
    return std::nullopt;
  }
  TrappedAirLaw air{which == 1 ? 1.0 : 1.4, core::quantity(table.get("temperature"), dimension::temperature)};
  if (const auto* item = table.find("ambient")) air.ambient = core::positive(*item, dimension::pressure);
  if (const auto* item = table.find("vent_area")) air.vent_area = core::positive(*item, dimension::area);
  if (const auto* item = table.find("seal_gap")) air.seal_gap = core::positive(*item, dimension::length);
  return air;
}

bool needs_air(const Body& body) {
  const auto open = [](const Boundary& boundary) { return boundary.kind == BoundaryKind::air; };
  return body.thermal && (body.emissivity > 0 || thermal::has_light(*body.thermal) ||
                          std::any_of(body.boundaries.begin(), body.boundaries.end(), open));
}

/// Tools that are not active are in the air too.
void refuse_missing_air(const CaseNode& stage, const Scene& scene) {
  const Body* body = needs_air(scene.glass) ? &scene.glass : nullptr;
  for (const Tool& tool : scene.tools)
    if (needs_air(tool)) body = &tool;
  if (!body) return;
  CaseNode place = stage;
  place.key += ".air";
  core::refuse(place,
               fmt::format("missing, but \"{}\" exchanges heat with the air; allowed is [air] for the case or air "
                           "in each stage",
                           body->name));
}

/// "off", or h and temperature; the temperature of a cooled boundary stays where none is given.
StageCooling read_exchange(const CaseNode& node, Index tool, std::size_t boundary, const Scene& scene) {
  const Boundary& given = scene.tools[tool].boundaries[boundary];
  StageCooling cooling{tool, boundary, 0, given.cooling.air_temperature};
  if (node.kind == CaseNode::Kind::text) {
    core::choice(node, {"off"});
    return cooling;
  }
  const CaseTable table(node, {"h", "temperature"});
  cooling.h = core::not_negative_over_time(table.get("h"), dimension::conductance);
  if (const auto* item = table.find("temperature"))
    cooling.air_temperature = core::quantity_over_time(*item, dimension::temperature);
  else if (given.kind != BoundaryKind::cooled || !given.cooling.air_temperature.is_constant())
    table.get("temperature");
  return cooling;
}

/// The boundaries of a tool that can be cooled, by name.
std::vector<std::string> coolable(const Tool& tool, bool only_cooled) {
  std::vector<std::string> names;
  for (const Boundary& boundary : tool.boundaries)
    if (boundary.kind == BoundaryKind::cooled ||
        (!only_cooled && (boundary.kind == BoundaryKind::contact || boundary.kind == BoundaryKind::air)))
      names.push_back(boundary.name);
  return names;
}

std::size_t index_of(const Tool& tool, const std::string& name) {
  const auto found = std::find_if(tool.boundaries.begin(), tool.boundaries.end(),
                                  [&](const Boundary& boundary) { return boundary.name == name; });
  return static_cast<std::size_t>(found - tool.boundaries.begin());
}

/// Of all cooled boundaries of a tool, or of those it names.
void read_tool_cooling(const CaseNode& node, Index index, const Scene& scene, Stage& stage) {
  const Tool& tool = scene.tools[index];
  const auto is_value = [](const CaseNode& item) { return item.name == "h" || item.name == "temperature"; };
  const bool is_table = node.kind == CaseNode::Kind::table;
  if (!is_table || std::any_of(node.items.begin(), node.items.end(), is_value)) {
    const auto names = coolable(tool, true);
    if (names.empty())
      core::refuse(node, fmt::format("\"{}\" has no cooled boundary, allowed is to name another: cooling.{} = {{ {} = "
                                     "{{ h = ..., temperature = ... }} }}",
                                     tool.name, tool.name, fmt::join(coolable(tool, false), " or ")));
    for (const auto& name : names) stage.cooling.push_back(read_exchange(node, index, index_of(tool, name), scene));
    return;
  }
  for (const CaseNode& item : node.items) {
    core::choice(core::key_of(item), coolable(tool, false));
    stage.cooling.push_back(read_exchange(item, index, index_of(tool, item.name), scene));
  }
}

void read_cooling(const CaseNode& node, const Scene& scene, Stage& stage) {
  if (!scene.has_heat()) core::refuse(node, "the glass carries no heat, this key is allowed only where it does");
  for (const CaseNode& item : core::entries(node))
    read_tool_cooling(item, static_cast<Index>(core::choice(core::key_of(item), tool_names(scene))), scene, stage);
}

/// The air of a stage, its own or that of the case; none where neither is given.
std::optional<Air> air_of(const CaseNode* own, const CaseNode* common) {
  if (!own && !common) return std::nullopt;
  Air air = read_air(own ? *own : *common);
  air.of_stage = own != nullptr;
  return air;
}

}  // namespace

void read_surroundings(const CaseTable& table, const CommonAir& common, Scene& scene, Stage& stage) {
  const auto *own_trapped = table.find("trapped_air"), *inner = table.find("inner_air");
  if (const auto* trapped = own_trapped ? own_trapped : common.trapped) stage.trapped_air = read_trapped_air(*trapped);
  if (const auto air = air_of(table.find("air"), common.air))
    stage.air = *air;
  else
    refuse_missing_air(table.node(), scene);
  stage.inner_air = air_of(inner, common.inner);
  if (inner) {
    name_inner_side(*inner, scene, stage);
    refuse_unknown_inner_side(*inner, scene, stage);
  }
  if (const auto* item = table.find("cooling")) read_cooling(*item, scene, stage);
}

}  // namespace parison::forming
