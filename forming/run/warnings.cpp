// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/run/warnings.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "forming/scene/container/container_plan.hpp"
#include "forming/state/start_temperature.hpp"
#include "forming/step/step_control.hpp"

namespace parison::forming {

namespace {

bool touches_glass(const State& state, Index tool) {
  const std::vector<Index>& touched = state.glass.contact_tool;
  return std::find(touched.begin(), touched.end(), tool) != touched.end();
}

/// What a tool that still moves at the end of its stage asks for.
std::string advice_for_moving_tool(const std::string& tool, bool is_touching) {
  if (is_touching)
    return "it has not finished its stroke. A longer duration or more force lets it come to rest against the glass";
  return fmt::format(
      "it touches no glass. If it moved away from the glass, turn the sign of motion.{}.force (positive is along "
      "+axis); "
      "if it has not reached the glass yet, it needs a longer duration or a start nearer to the glass",
      tool);
}

}  // namespace

Warnings moving_tool_warnings(const Scene& scene, const State& state) {
  Warnings warnings;
  const Stage& stage = scene.stages[state.stage];
  if (!stage.end_speed) return warnings;
  for (const StageTool& tool : stage.tools) {
    const auto* motion = std::get_if<ForceMotion>(&tool.motion);
    if (!motion) continue;
    const std::string& name = scene.tools[tool.tool].name;
    const double speed = std::abs(state.tools[tool.tool].velocity);
    if (speed >= *stage.end_speed)
      warnings.push_back(fmt::format(
          "stage {} ended by its duration of {:g} s while {} still moved at {:.3g} mm/s, above its end_speed of {:g} "
          "mm/s: {}",
          stage.name, stage.duration, name, 1e3 * speed, 1e3 * *stage.end_speed,
          advice_for_moving_tool(name, touches_glass(state, tool.tool))));
    else if (!state.has_moved)
      warnings.push_back(fmt::format(
          "stage {} ended by its duration of {:g} s, and {} never moved faster than its end_speed of {:g} mm/s: a "
          "force of up to {:.4g} N hardly moves it, and the glass may not be pressed to its shape. More force or "
          "hotter glass moves it; where it should creep, a lower end_speed lets the stage end by it",
          stage.name, stage.duration, name, 1e3 * *stage.end_speed, motion->force.max_size()));
  }
  return warnings;
}

namespace {

/// What would bring a tool further that stands short of a place, m, and moves towards it at a speed, m/s, at the end of
/// a stage of that time, s.
std::string advice_for_short_tool(double force, double missing, double speed, double speed_limit, double time) {
  constexpr double at_limit = 0.999;
  if (speed >= at_limit * speed_limit)
    return fmt::format(
        "It still moved at its speed_limit of {:.3g} mm/s: a later end of the stage or a higher speed_limit brings it "
        "further",
        1e3 * speed_limit);
  const std::string pressed = fmt::format("Its force of {:.4g} N", std::abs(force));
  const char* const remedy = "more force, a hotter gob or less friction";
  if (!(speed > 0)) return fmt::format("{} moved it no further: it takes {}", pressed, remedy);
  if (speed * time < missing)
    return fmt::format(
        "{} still moved it at {:.3g} mm/s, by which it comes at most {:.2g} mm further in as long a stage again: it "
        "takes {}",
        pressed, 1e3 * speed, 1e3 * speed * time, remedy);
  return fmt::format("{} still moved it at {:.3g} mm/s: a later end of the stage brings it further, or {}", pressed,
                     1e3 * speed, remedy);
}

/// The tools of the present stage that no glass touches, but one: ", and no glass touched plate"; empty without any.
std::string untouched_tools(const Scene& scene, const State& state, Index but) {
  std::string names;
  for (const StageTool& tool : scene.stages[state.stage].tools)
    if (tool.tool != but && !touches_glass(state, tool.tool))
      names += (names.empty() ? "" : " or ") + scene.tools[tool.tool].name;
  return names.empty() ? "" : ", and no glass touched " + names;
}

/// Whether a larger force has driven the tool in an earlier stage.
bool was_pressed_harder(const Scene& scene, Index stage, Index tool, double force) {
  return std::any_of(scene.stages.begin(), scene.stages.begin() + stage, [&](const Stage& earlier) {
    return std::any_of(earlier.tools.begin(), earlier.tools.end(), [&](const StageTool& entry) {
      const auto* motion = std::get_if<ForceMotion>(&entry.motion);
      return entry.tool == tool && motion && motion->force.max_size() > force;
    });
  });
}

/// That a tool stands short of the offset, m, at which it has filled its cavity.
std::string short_tool(const Scene& scene, const State& state, Index tool, const ForceMotion& motion, double full) {
  const ToolState& body = state.tools[tool];
  const double missing = std::abs(full - body.offset), speed = full > body.offset ? body.velocity : -body.velocity;
  const double speed_limit = motion.speed_limit(state.stage_time - 0.5 * state.last_step);
  return fmt::format(
      "stage {} ended ({}) before the glass filled its cavity: {} stood at {:.2f} mm, {:.3g} mm short of {:.2f} mm, "
      "where the cavity is full{}. {}",
      scene.stages[state.stage].name, name_of(stage_end(scene, state)), scene.tools[tool].name, 1e3 * body.offset,
      1e3 * missing, 1e3 * full, untouched_tools(scene, state, tool),
      advice_for_short_tool(body.force, missing, speed, speed_limit, state.stage_time));
}

}  // namespace

std::optional<std::string> unfilled_cavity(const Scene& scene, const State& state) {
  if (scene.geometry != core::Geometry::axisymmetric) return {};
  std::vector<double> offset;
  for (const ToolState& tool : state.tools) offset.push_back(tool.offset);
  std::optional<std::string> told;
  for (const StageTool& entry : scene.stages[state.stage].tools) {
    const auto* motion = std::get_if<ForceMotion>(&entry.motion);
    if (!motion) continue;
    const double volume = core::volume(state.glass.mesh, scene.geometry);
    const auto full = full_offset(scene, offset, state.stage, entry.tool, volume);
    if (full == offset[entry.tool])
      told = "";
    else if (full && !was_pressed_harder(scene, state.stage, entry.tool, motion->force.max_size()))
      told = short_tool(scene, state, entry.tool, *motion, *full);
  }
  return told;
}

Warnings remeshing_warnings(const State& state) {
  Warnings warnings;
  const RemeshStatistics& remeshing = state.totals.remeshing;
  if (remeshing.laps > 0)
    warnings.push_back(fmt::format(
        "the glass folded onto itself at {}. {} closed and {} {:.2g} mm3 of air; the container would show fold marks "
        "(laps) there. A hotter gob, a slower plunger or less friction keeps the surface apart; the VTU files show "
        "where",
        remeshing.laps == 1 ? "one point" : fmt::format("{} points", remeshing.laps),
        remeshing.laps == 1 ? "The fold was" : "The folds were", remeshing.laps == 1 ? "encloses" : "enclose",
        1e9 * remeshing.lap_volume));
  if (remeshing.enclosed > 0)
    warnings.push_back(fmt::format(
        "glass met glass at {} and joined around {:.2g} mm3 of air, whose pressure is not counted: the container would "
        "have a bubble there. A hotter gob or less friction fills the tools without one; the VTU files show where",
        remeshing.enclosed == 1 ? "one place" : fmt::format("{} places", remeshing.enclosed),
        1e9 * remeshing.enclosed_volume));
  if (remeshing.torn > 0)
    warnings.push_back(fmt::format(
        "{}, {:.2g} mm3, tore off where the glass had thinned to nothing. That glass was given to the rest; on a "
        "machine it would stay on a tool. Less friction or a hotter tool there lets the glass slide",
        remeshing.torn == 1 ? "one piece of glass" : fmt::format("{} pieces of glass", remeshing.torn),
        1e9 * remeshing.torn_volume));
  return warnings;
}

namespace {

/// What came to a tool that the glass never touched through the faces that it could touch, with an enclosure.
std::string exchanged_by_light(const Scene& scene, const Tool& tool, const ToolState& body) {
  if (!scene.enclosure || body.heat_from_enclosure == 0) return "";
  double gained = 0;
  for (std::size_t i = 0; i < body.heat_through.size(); ++i)
    if (tool.boundaries[i].kind == BoundaryKind::contact) gained -= body.heat_through[i];
  return fmt::format(" by contact; {:.4g} J {} {} through its open faces by light and air", std::abs(gained),
                     gained < 0 ? "left" : "came to", tool.name);
}

}  // namespace

Warnings unused_interface_warnings(const Scene& scene, const State& state) {
  Warnings warnings;
  for (const Interface& interface : scene.interfaces) {
    const Tool& tool = scene.tools[interface.tool];
    const ToolState& body = state.tools[interface.tool];
    if (body.heat_received == 0 && tool.initial_temperature != scene.glass.initial_temperature)
      warnings.push_back(fmt::format(
          "the glass never reached {0}: during the whole run they stayed farther apart than {1:.4g} mm, and no heat "
          "passed between them{2}. Where it should reach it, the glass was too cold or too little, or was not pressed "
          "or "
          "blown far enough, or the tool is not where it should be (`parison check --picture` draws it)",
          tool.name, 1e3 * interface.transition_gap, exchanged_by_light(scene, tool, body)));
  }
  return warnings;
}

Warnings start_field_warnings(const Scene& scene, const State& state) {
  Warnings warnings;
  for (Index body = 0; body < body_count(state); ++body) {
    const PlacedTemperature function = start_function(scene, body);
    if (!function || temperature_of(state, body).size() == 0) continue;
    const double share = misfit(mesh_of(state, body), scene.geometry, temperature_of(state, body), function).share();
    if (share > 2 * start_field_tolerance)
      warnings.push_back(fmt::format(
          "the temperatures of {} at the start are steeper than its mesh: it has the heat that was given, but differs "
          "from place to place by {:.2g} % of what they vary. Smaller cells (mesh.size, mesh.contact_size of the body, "
          "numerics.skin_size for glass that flows) show them",
          body_of(scene, body).name, 100 * share));
  }
  return warnings;
}

void add_warnings(const Warnings& warnings, RunFacts& facts) {
  facts.warnings.insert(facts.warnings.end(), warnings.begin(), warnings.end());
}

}  // namespace parison::forming
