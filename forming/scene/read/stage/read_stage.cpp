// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "forming/flow/contact/constraints.hpp"
#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

Motion read_motion(const CaseNode& node, const Scene& scene) {
  const CaseTable table(node, {"offset", "force", "speed_limit"});
  if (const auto* offset = table.find("offset")) {
    if (table.find("force") || table.find("speed_limit"))
      core::refuse(node, "offset and force were found, allowed is one of them");
    return PositionMotion{core::quantity_table(*offset, dimension::time, dimension::length)};
  }
  if (!scene.has_flow())
    core::refuse(table.get("force"), "a force was found but the glass does not flow, allowed is offset");
  const auto& force = table.get("force");
  const ForceMotion motion{core::quantity_over_time(force, dimension::force),
                           core::positive_over_time(table.get("speed_limit"), dimension::speed)};
  if (motion.force.max_size() == 0)
    core::refuse(force, force.text.empty()
                            ? "no force but zero was found, allowed is one other than zero"
                            : fmt::format("\"{}\" was found, allowed is a force other than zero", force.text));
  return motion;
}

std::vector<StageTool> read_stage_tools(const CaseTable& table, const Scene& scene) {
  std::vector<StageTool> tools;
  std::vector<std::string> active_names;
  if (const auto* node = table.find("tools"))
    for (const auto& item : core::list(*node)) {
      const Index tool = core::choice(item, tool_names(scene));
      if (std::count(active_names.begin(), active_names.end(), item.text))
        core::refuse(item, fmt::format("\"{}\" was found twice, allowed is once", item.text));
      active_names.push_back(item.text);
      tools.push_back({tool, {}});
    }
  if (const auto* node = table.find("motion"))
    for (const auto& item : core::entries(*node)) {
      const auto at = std::find(active_names.begin(), active_names.end(), item.name);
      if (at == active_names.end())
        core::refuse(
            item,
            fmt::format("a motion of \"{}\", which is not active in this stage, allowed are the stage's tools: {}",
                        item.name, fmt::join(active_names, ", ")));
      tools[at - active_names.begin()].motion = read_motion(item, scene);
      if (std::count_if(tools.begin(), tools.end(), [](const auto& one) { return one.is_driven(); }) >
          flow::max_driven_tools)
        core::refuse(item, fmt::format("too many tools driven by a force were found, allowed are {} in a stage",
                                       flow::max_driven_tools));
    }
  return tools;
}

/// The open boundaries of the glass that a pressure may act on, with those named up to this stage.
std::vector<std::string> open_boundaries(const Scene& scene, const Stage& stage) {
  std::vector<std::string> names;
  for (const auto& boundary : scene.glass.boundaries)
    if (boundary.kind != BoundaryKind::symmetry && boundary.kind != BoundaryKind::fixed) names.push_back(boundary.name);
  for (const auto& earlier : scene.stages)
    for (const auto& named : earlier.named_boundaries) names.push_back(named.name);
  for (const auto& named : stage.named_boundaries) names.push_back(named.name);
  return names;
}

void refuse_end(const CaseNode& node, const char* reason) {
  core::refuse(node, fmt::format("{}, allowed is another condition or the duration alone", reason));
}

std::vector<EndCondition> read_ends(const CaseNode& node, const Scene& scene, const Stage& stage) {
  using Kind = EndCondition::Kind;
  const CaseTable table(node, {"force", "filled", "within", "surface_below", "surface_above", "lowest"});
  std::vector<EndCondition> ends;
  if (const auto* item = table.find("force")) {
    if (stage.tools.empty() || !scene.has_flow()) refuse_end(*item, "no tool presses on flowing glass in this stage");
    ends.push_back({Kind::force, core::positive(*item, dimension::force)});
  }
  if (const auto* item = table.find("filled")) {
    const double share = core::positive(*item, dimension::none), within_default = 0.2e-3;
    if (share > 1) core::refuse(*item, fmt::format("a share of {:g} was found, allowed are shares up to 100 %", share));
    if (stage.tools.empty()) refuse_end(*item, "no tool is active in this stage");
    const auto* within = table.find("within");
    ends.push_back({Kind::filled, share, within ? core::positive(*within, dimension::length) : within_default});
  } else if (const auto* within = table.find("within")) {
    core::refuse(*within, "a distance was found, allowed only together with \"filled\"");
  }
  for (const auto& [key, kind] :
       {std::pair{"surface_below", Kind::surface_below}, {"surface_above", Kind::surface_above}})
    if (const auto* item = table.find(key)) {
      if (!scene.has_heat()) refuse_end(*item, "the glass carries no heat");
      ends.push_back({kind, core::quantity(*item, dimension::temperature)});
    }
  if (const auto* item = table.find("lowest")) {
    if (stage.gravity == 0) refuse_end(*item, "the stage has no gravity, which says what is low");
    ends.push_back({Kind::lowest, core::quantity(*item, dimension::length)});
  }
  if (ends.empty())
    core::refuse(node, "no condition was found, allowed are force, filled, surface_below, surface_above, lowest");
  return ends;
}

/// What only flowing glass obeys: gravity, pressures, the end condition.
void read_loads(const CaseTable& table, Scene& scene, Stage& stage) {
  if (!scene.has_flow())
    for (const auto* key : {"gravity", "pressure", "end_speed", "name_boundary", "trapped_air"})
      if (const auto* item = table.find(key))
        core::refuse(*item, "the glass does not flow, this key is allowed only where its material has a viscosity");
  if (const auto* item = table.find("gravity")) stage.gravity = core::quantity(*item, dimension::acceleration);
  read_named_boundaries(table, scene, stage);
  if (const auto* pressures = table.find("pressure"))
    for (const auto& item : core::entries(*pressures)) {
      if (item.name == inner_side) name_inner_side(item, scene, stage);
      core::choice(core::key_of(item), open_boundaries(scene, stage));
      stage.pressure[item.name] = core::quantity_over_time(item, dimension::pressure);
    }
  if (const auto* item = table.find("end_speed")) {
    stage.end_speed = core::positive(*item, dimension::speed);
    if (!stage.has_driven_tool())
      core::refuse(*item, "an end speed was found, allowed only where a force drives a tool");
  }
}

}  // namespace

Stage read_stage(const CaseNode& node, const CommonAir& common, Scene& scene) {
  const CaseTable table(
      node, {"name", "duration", "from", "until", "end_speed", "gravity", "tools", "motion", "pressure", "end", "air",
             "inner_air", "trapped_air", "cooling", "name_boundary", "kind", "lehr", "solid"});
  Stage stage;
  stage.name = core::identifier(table.get("name"));
  read_kind(table, scene, stage);
  const auto* lehr = table.find("lehr");
  if (lehr)
    read_lehr(*lehr, table, stage);
  else
    read_times(table, scene, stage);
  stage.tools = read_stage_tools(table, scene);
  read_loads(table, scene, stage);
  if (const auto* item = table.find("end")) stage.ends = read_ends(*item, scene, stage);
  if (const auto* item = table.find("solid")) read_solid(*item, stage, scene);
  if (lehr) return stage;
  read_surroundings(table, common, scene, stage);
  return stage;
}

}  // namespace parison::forming
