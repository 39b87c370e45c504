// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "forming/flow/constraints.hpp"
#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

thermal::SurfaceExchange read_air(const CaseNode& node) {
  const CaseTable table(node, {"temperature", "h", "ambient"});
  thermal::SurfaceExchange air;
  air.h = core::not_negative(table.get("h"), dimension::conductance);
  air.air_temperature = core::quantity(table.get("temperature"), dimension::temperature);
  air.ambient_temperature = core::quantity(table.get("ambient"), dimension::temperature);
  return air;
}

bool needs_air(const Body& body) {
  const auto open = [](const Piece& piece) { return piece.kind == PieceKind::air; };
  return body.thermal && (body.emissivity > 0 || std::any_of(body.pieces.begin(), body.pieces.end(), open));
}

/// Tools out of place stand in the air too.
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

Motion read_motion(const CaseNode& node, const Scene& scene) {
  const CaseTable table(node, {"offset", "force", "speed_limit"});
  if (const auto* offset = table.find("offset")) {
    if (table.find("force") || table.find("speed_limit"))
      core::refuse(node, "offset and force were found, allowed is one of them");
    return PositionMotion{core::quantity_table(*offset, dimension::time, dimension::length)};
  }
  if (!scene.has_flow()) core::refuse(table.get("force"), "a force on glass that does not flow, allowed is offset");
  const auto& force = table.get("force");
  if (core::quantity(force, dimension::force) == 0)
    core::refuse(force, fmt::format("\"{}\" was found, allowed is a force other than zero", force.text));
  return ForceMotion{core::quantity(force, dimension::force),
                     core::positive(table.get("speed_limit"), dimension::speed)};
}

bool is_driven(const StageTool& tool) {
  return std::holds_alternative<ForceMotion>(tool.motion);
}

std::vector<StageTool> read_stage_tools(const CaseTable& table, const Scene& scene) {
  std::vector<StageTool> tools;
  std::vector<std::string> in_place;
  if (const auto* node = table.find("tools"))
    for (const auto& item : core::list(*node)) {
      const Index tool = core::choice(item, tool_names(scene));
      if (std::count(in_place.begin(), in_place.end(), item.text))
        core::refuse(item, fmt::format("\"{}\" was found twice, allowed is once", item.text));
      in_place.push_back(item.text);
      tools.push_back({tool, {}});
    }
  if (const auto* node = table.find("motion"))
    for (const auto& item : core::entries(*node)) {
      const auto at = std::find(in_place.begin(), in_place.end(), item.name);
      if (at == in_place.end())
        core::refuse(item, fmt::format("a motion of \"{}\", which is not in place, allowed are the stage's tools: {}",
                                       item.name, fmt::join(in_place, ", ")));
      tools[at - in_place.begin()].motion = read_motion(item, scene);
      if (std::count_if(tools.begin(), tools.end(), is_driven) > flow::most_driven)
        core::refuse(item, fmt::format("one more tool driven by a force was found, allowed are {} in a stage",
                                       flow::most_driven));
    }
  return tools;
}

/// The open pieces of the glass that a pressure may act on, with those named up to this stage.
std::vector<std::string> open_pieces(const Scene& scene, const Stage& stage) {
  std::vector<std::string> names;
  for (const auto& piece : scene.glass.pieces)
    if (piece.kind != PieceKind::symmetry && piece.kind != PieceKind::fixed) names.push_back(piece.name);
  for (const auto& earlier : scene.stages)
    for (const auto& stretch : earlier.name_pieces) names.push_back(stretch.name);
  for (const auto& stretch : stage.name_pieces) names.push_back(stretch.name);
  return names;
}

void read_name_pieces(const CaseTable& table, const Scene& scene, Stage& stage) {
  refuse_repeated_names(table.tables("name_piece"));
  for (const auto* node : table.tables("name_piece")) {
    const CaseTable stretch(*node, {"name", "from", "to"});
    const auto& name = core::identifier(stretch.get("name"));
    const auto taken = [&](const Piece& piece) { return piece.name == name; };
    if (std::any_of(scene.glass.pieces.begin(), scene.glass.pieces.end(), taken))
      core::refuse(stretch.get("name"),
                   fmt::format("\"{}\" is a piece of the glass already, allowed is a new name", name));
    for (const auto& earlier : scene.stages)
      for (const auto& other : earlier.name_pieces)
        if (other.name == name)
          core::refuse(stretch.get("name"),
                       fmt::format("stage \"{}\" names \"{}\" already, allowed is a new name", earlier.name, name));
    stage.name_pieces.push_back({name, read_point(stretch.get("from")), read_point(stretch.get("to"))});
  }
}

/// What only flowing glass obeys: gravity, pressures, the end condition.
void read_loads(const CaseTable& table, const Scene& scene, Stage& stage) {
  if (!scene.has_flow())
    for (const auto* key : {"gravity", "pressure", "end_speed", "name_piece"})
      if (const auto* item = table.find(key))
        core::refuse(*item, "the glass does not flow, allowed is this key where its material has a viscosity");
  if (const auto* item = table.find("gravity")) stage.gravity = core::quantity(*item, dimension::acceleration);
  read_name_pieces(table, scene, stage);
  if (const auto* pressures = table.find("pressure"))
    for (const auto& item : core::entries(*pressures)) {
      core::choice(core::key_of(item), open_pieces(scene, stage));
      stage.pressure[item.name] = core::quantity(item, dimension::pressure);
    }
  if (const auto* item = table.find("end_speed")) {
    stage.end_speed = core::positive(*item, dimension::speed);
    if (std::none_of(stage.tools.begin(), stage.tools.end(), is_driven))
      core::refuse(*item, "an end speed was found, allowed is it where a force drives a tool");
  }
}

}  // namespace

Stage read_stage(const CaseNode& node, const CaseNode* air, const Scene& scene) {
  const CaseTable table(
      node, {"name", "duration", "end_speed", "gravity", "tools", "motion", "pressure", "air", "name_piece"});
  Stage stage;
  stage.name = core::identifier(table.get("name"));
  stage.duration = core::positive(table.get("duration"), dimension::time);
  stage.tools = read_stage_tools(table, scene);
  read_loads(table, scene, stage);
  if (const auto* own = table.find("air")) air = own;
  if (air) stage.air = read_air(*air);
  if (!air) refuse_missing_air(node, scene);
  return stage;
}

}  // namespace parison::forming
