// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/math/numbers.hpp"
#include "forming/scene/container/container_plan.hpp"
#include "forming/scene/describe/describe_timing.hpp"
#include "forming/scene/describe/dimensionless_numbers.hpp"
#include "forming/scene/describe/model_sensitivity.hpp"
#include "forming/scene/describe/support.hpp"
#include "forming/scene/describe/unusual.hpp"
#include "forming/scene/preset_scales.hpp"
#include "thermal/properties.hpp"

namespace parison::forming {
namespace {

/// A part of the physics, on with what it does or off with why.
std::string part(const char* name, bool on, const std::string& what, const std::string& why_not) {
  return fmt::format("  {:<20}{:<5}{}\n", name, on ? "on" : "off", on ? what : why_not);
}

template <typename Test>
std::string stages_with(const Scene& scene, const Test& test) {
  std::string names;
  for (const Stage& stage : scene.stages)
    if (test(stage)) names += (names.empty() ? "" : ", ") + stage.name;
  return names;
}

const char* law_name(const flow::Viscosity& viscosity) {
  return viscosity.constant ? "constant" : viscosity.table ? "tabulated" : "VFT";
}

std::string flow_parts(const Scene& scene) {
  const bool on = scene.has_flow();
  const auto or_no_flow = [on](const char* reason) { return on ? reason : "the glass does not flow"; };
  const auto gravity = stages_with(scene, [](const Stage& s) { return s.gravity != 0; });
  const auto pressure = stages_with(scene, [](const Stage& s) { return !s.pressure.empty(); });
  const double tension = on ? scene.glass.flow->surface_tension : 0;
  std::string text =
      part("flow", on, fmt::format("Taylor-Hood P2-P1, {} viscosity", on ? law_name(scene.glass.flow->viscosity) : ""),
           "the glass's material has no viscosity");
  text += part("shear thinning", on && scene.glass.flow->shear_thinning, "Carreau factor",
               or_no_flow("the material names none"));
  text += part("gravity", on && !gravity.empty(), "in " + gravity, or_no_flow("no stage names it"));
  text += part("air pressure", on && !pressure.empty(), "in " + pressure, or_no_flow("no stage names one"));
  const auto sealed = stages_with(scene, [](const Stage& s) { return s.trapped_air.has_value(); });
  text += part("trapped air", on && !sealed.empty(), "in " + sealed, or_no_flow("cavities are vented"));
  text +=
      part("surface tension", tension > 0, fmt::format("{:.3g} N/m", tension), or_no_flow("the material names none"));
  text += part("contact with tools", on && !scene.tools.empty(),
               fmt::format("unilateral, tools: {}", scene.tools.size()), or_no_flow("the scene has no tools"));
  return text + part("inertia", false, "", or_no_flow("neglected: see the Reynolds number"));
}

std::string radiation_text(const Scene& scene) {
  if (!scene.has_light()) return "Rosseland conductivity";
  const thermal::Radiation& radiation = *scene.glass.thermal->radiation;
  using Model = thermal::Radiation::Model;
  const char* model = radiation.model == Model::transfer   ? "radiative transfer along rays"
                      : radiation.model == Model::p1_cones ? "P1 in cones"
                                                           : "P1";
  const double last = radiation.bands.back().up_to;
  return fmt::format("{}, {} band{}{}{}", model, radiation.bands.size(), radiation.bands.size() == 1 ? "" : "s",
                     thermal::absorption_varies(*scene.glass.thermal) ? ", absorption by temperature" : "",
                     std::isfinite(last) ? fmt::format(", opaque beyond {:g} um", 1e6 * last) : "");
}

std::string heat_parts(const Scene& scene) {
  const bool on = scene.has_heat();
  const std::string no_heat = "the glass carries no heat";
  const auto air = stages_with(scene, [](const Stage& s) { return s.air.h.max() > 0; });
  const double emissivity = scene.glass.emissivity;
  std::string exchange = air.empty() ? "" : "air in " + air;
  if (emissivity > 0) exchange += fmt::format("{}emissivity {:.3g}", air.empty() ? "" : ", ", emissivity);
  if (scene.enclosure) exchange += ", surfaces see each other";
  std::size_t hot_tools = 0;
  for (const Tool& tool : scene.tools) hot_tools += tool.thermal.has_value();
  std::string text = part("heat", on, fmt::format("in the glass, in tools: {}", hot_tools),
                          "the glass's material has no heat capacity and conductivity");
  text += part("internal radiation", on && scene.glass.thermal->radiation, radiation_text(scene),
               on ? "the material names none" : no_heat);
  if (scene.radiation_choice) text += part("  chosen", true, describe(*scene.radiation_choice), "");
  text +=
      part("interfaces", on && !scene.interfaces.empty(),
           fmt::format("mortar, glass with tools: {}", scene.interfaces.size()), on ? "the scene names none" : no_heat);
  text += part("air and radiation", on && !exchange.empty(), exchange,
               on ? "no stage names air and the glass has no emissivity" : no_heat);
  return text + part("dissipation", on && scene.has_flow(), "viscous work heats the glass",
                     on ? "the glass does not flow" : no_heat);
}

std::string number_lines(const Scene& scene, const DimensionlessNumbers& numbers) {
  const auto shown = [](const std::optional<double>& value) { return value ? fmt::format("{:.3g}", *value) : "n/a"; };
  std::string text =
      fmt::format("\nglass                 {:.4g} g, {:.4g} cm3{} as drawn\n", 1e3 * numbers.mass, 1e6 * numbers.volume,
                  scene.geometry == core::Geometry::planar ? " a metre of depth" : "");
  text += describe_support(scene);
  text += fmt::format("\nnumbers at the start (length {:.3g} mm, speed {} m/s, viscosity {} Pa.s)\n",
                      1e3 * numbers.length, shown(numbers.speed), shown(numbers.viscosity));
  text += fmt::format("  {:<20}{:<12}inertia over viscous stress\n", "Reynolds", shown(numbers.reynolds));
  text += fmt::format("  {:<20}{:<12}viscous stress over surface tension\n", "capillary", shown(numbers.capillary));
  text += fmt::format("  {:<20}{:<12}convected over conducted heat\n", "Peclet", shown(numbers.peclet));
  text += fmt::format("  {:<20}{:<12}surface exchange over conduction, largest h\n", "Biot", shown(numbers.biot));
  return text + fmt::format("  {:<20}{:<12}dissipated over conducted heat\n", "Brinkman", shown(numbers.brinkman));
}

/// "8000", or "0 to 8000" of what changes with time, in units of 1/scale.
std::string range_text(const core::TimeFunction& value, double scale = 1) {
  if (value.min() == value.max()) return fmt::format("{:.4g}", scale * value.max());
  return fmt::format("{:.4g} to {:.4g}", scale * value.min(), scale * value.max());
}

/// Whether a tool of the scene moves in any stage.
bool has_moving_tool(const Scene& scene) {
  for (const Stage& stage : scene.stages)
    for (const StageTool& tool : stage.tools)
      if (fastest(tool) > 0) return true;
  return false;
}

/// What the friction of each tool with Navier's law means for hot glass: a layer half as thick as the glass's own
/// length shears in series with the friction, which takes this share of a tool's speed.
std::string friction_lines(const Scene& scene, const DimensionlessNumbers& numbers) {
  constexpr double stick_below = 0.1, slip_above = 0.9;
  if (!numbers.viscosity) return "";
  const bool moves = numbers.speed && has_moving_tool(scene);
  std::string text;
  for (const Tool& tool : scene.tools) {
    const double coefficient = tool.friction.coefficient_at(scene.glass.initial_temperature);
    if (tool.friction.law != flow::Friction::Law::navier) continue;
    const double share = 1 / (1 + coefficient * 0.5 * numbers.length / *numbers.viscosity);
    text += fmt::format("  {:<20}{:g} Pa.s/m: ", tool.name, coefficient);
    if (moves)
      text += fmt::format("{:.2g} bar at {:.3g} m/s; ", coefficient * *numbers.speed / core::bar, *numbers.speed);
    text += fmt::format("hot glass slides at {:.1f} % of the speed of free slip: {}\n", 100 * share,
                        share < stick_below  ? "acts as stick"
                        : share > slip_above ? "acts as slip"
                                             : "slides and drags");
  }
  return text.empty()
             ? ""
             : "\nfriction (no measured value for hot glass is known; 1e4 to 1e7 Pa.s/m is the range to try)\n" + text;
}

/// The constants in force of contacts by the gap, which have published values where the case gives none.
std::string gap_lines(const Scene& scene) {
  std::string text;
  for (const Interface& interface : scene.interfaces)
    if (const auto* law = std::get_if<contact::GapConductance>(&interface.law))
      text +=
          fmt::format("  {:<20}{:g} um at first touch, to {:g} um in about {:g} s; closing {:g}, accommodation {:g}\n",
                      scene.tools[interface.tool].name, 1e6 * law->touch_gap, 1e6 * law->open_gap, law->opening_time,
                      law->closing, law->accommodation);
  return text.empty() ? "" : "\ncontact by the gap\n" + text;
}

/// A force in N, from 1000 N on in kN.
std::string force_text(const core::TimeFunction& force) {
  const bool is_large = force.max_size() >= 1e3;
  return range_text(force, is_large ? 1e-3 : 1) + (is_large ? " kN" : " N");
}

std::string stage_tool_text(const Scene& scene, const StageTool& tool) {
  const std::string& name = scene.tools[tool.tool].name;
  if (const auto* force = std::get_if<ForceMotion>(&tool.motion))
    return fmt::format("{} ({}, at most {} mm/s)", name, force_text(force->force), range_text(force->speed_limit, 1e3));
  return std::holds_alternative<PositionMotion>(tool.motion) ? name + " (moved)" : name;
}

std::string stage_lines(const Scene& scene) {
  std::string text = "\nstages\n";
  for (const Stage& stage : scene.stages) {
    std::string tools;
    for (const StageTool& tool : stage.tools) tools += (tools.empty() ? "" : ", ") + stage_tool_text(scene, tool);
    const char* limit = stage.may_end_early() ? "at most " : "";
    text +=
        fmt::format("  {:<20}{}{:.4g} s; {}\n", stage.name, limit, stage.duration, tools.empty() ? "no tools" : tools);
    for (const NamedBoundary& named : stage.named_boundaries)
      if (named.touched)
        text += fmt::format("  {:<20}names {}: what {} touched\n", "", named.name, scene.tools[*named.touched].name);
    text += describe_named_points(scene, stage);
    if (scene.solid && &stage == &scene.stages[scene.solid->from_stage])
      text += fmt::format("  {:<20}from here on the glass is a body in space, a sector of {:.0f} deg\n", "",
                          scene.solid->sector * 180 / M_PI);
  }
  return text;
}

std::string choice_text(const Scene& scene) {
  const auto target = scene.accuracy_choice.target;
  if (!target) return "preset";
  return fmt::format(
      "wall thickness and heat into tools to {:.3g} %: `parison run` finds the settings by runs of this scene, those "
      "below are a guess",
      100 * *target);
}

/// Whether a setting is for meshes that the case maps itself.
bool is_unused(const Scene& scene, const std::string& key) {
  const auto maps = [](const Tool& tool) { return tool.mesh.mapped.has_value(); };
  if (key.rfind("tool_", 0) == 0)
    return !scene.tools.empty() && std::all_of(scene.tools.begin(), scene.tools.end(), maps);
  const bool of_glass = key == "surface_size" || key == "skin_size" || key == "elements_across";
  return of_glass && scene.glass.mesh.mapped && !scene.has_flow();
}

std::string accuracy_lines(const Scene& scene) {
  const AccuracyChoice& choice = scene.accuracy_choice;
  std::string text = fmt::format("\naccuracy {} ({}; level {:.3g}, 0 is draft, 1 standard, 2 fine)\n",
                                 scene.accuracy_name, choice_text(scene), choice.level);
  const double scale = preset_length_scale(scene);
  const auto add = [&](const char* key, double value, const char* unit, bool scaled) {
    const auto own = scene.accuracy_origin.find(key);
    const std::string origin = own != scene.accuracy_origin.end() ? own->second
                               : is_unused(scene, key)            ? "not used: the case maps its mesh"
                               : choice.target                    ? "guess"
                               : scaled && scale > 1
                                   ? fmt::format("preset, {:.3g} times as long for so much glass", scale)
                                   : "preset";
    text += fmt::format("  {:<24}{:<12}{}{}\n", key, fmt::format("{:.4g}{}{}", value, *unit ? " " : "", unit), origin,
                        choice.coarsening_factor == 1 ? "" : ", made coarser");
  };
  for (const Setting& setting : settings())
    add(setting.key, scene.accuracy.*setting.value / setting.unit_size, setting.unit, is_length(setting));
  return text;
}

}  // namespace

std::string describe_scene(const Scene& scene) {
  const char* geometry = scene.geometry == core::Geometry::axisymmetric ? "axisymmetric" : "planar";
  std::string head = fmt::format("{}, {}\n", scene.name, geometry);
  for (const auto& assignment : scene.overrides) head += fmt::format("  {:<20}{}\n", "override", assignment);
  for (const auto& dimension : scene.dimensions)
    head += fmt::format("  {:<20}{} = {}\n", "dimension", dimension.name, dimension.given);
  for (const auto& tolerance : scene.tolerances)
    head += fmt::format("  {:<20}{} = {}\n", "tolerance", tolerance.key, tolerance.given);
  const DimensionlessNumbers numbers = dimensionless_numbers(scene);
  return head + flow_parts(scene) + heat_parts(scene) + describe_sensitivity(scene) + number_lines(scene, numbers) +
         friction_lines(scene, numbers) + gap_lines(scene) + describe_container(scene) + stage_lines(scene) +
         describe_timing(scene) + accuracy_lines(scene) + describe_unusual(scene);
}

std::string describe_scene_briefly(const Scene& scene) {
  const DimensionlessNumbers numbers = dimensionless_numbers(scene);
  double longest = 0;
  for (const Stage& stage : scene.stages) longest += stage.duration;
  std::string text =
      fmt::format("{} at {} accuracy: {:.4g} g of glass, tools: {}, stages: {}, at most {:.4g} s\n", scene.name,
                  scene.accuracy_name, 1e3 * numbers.mass, scene.tools.size(), scene.stages.size(), longest);
  text += describe_support(scene);
  for (const auto& assignment : scene.overrides) text += fmt::format("  {:<20}{}\n", "override", assignment);
  if (scene.radiation_choice) text += fmt::format("  {:<20}{}\n", "radiation", describe(*scene.radiation_choice));
  for (const Setting& setting : settings())
    if (const auto own = scene.accuracy_origin.find(setting.key); own != scene.accuracy_origin.end())
      text += fmt::format("  {:<20}{} {:.4g} {}, from {}\n", "numerics", setting.key,
                          scene.accuracy.*setting.value / setting.unit_size, setting.unit, own->second);
  return text;
}

}  // namespace parison::forming
