// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <fmt/format.h>

#include "forming/scene/outline_place.hpp"
#include "forming/scene/read/scene_reading.hpp"
#include "forming/scene/read/tolerances.hpp"

namespace parison::forming {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

namespace {

bool is_in(const Body& body, const core::Point& point) {
  const double on_outline = tolerance::on_outline * core::size(body.profile);
  return core::contains(body.profile, point) || core::distance(body.profile, point) <= on_outline;
}

/// What a probe outside its body may have instead, by the contact boundary that is closest to it.
std::string advice(const Body& body, const core::Point& point) {
  const auto place = closest_contact(body, point);
  if (!place) return "";
  return fmt::format("; with boundary = \"{}\" and a depth such as \"5 mm\" it follows the drawing",
                     body.profile.boundary_names[place->boundary]);
}

/// The point so deep behind the place of a boundary that is closest to the one given.
core::Point behind(const Body& body, Index boundary, const core::Point& near, double depth) {
  const auto place = *closest_place(body, near, [&](Index id) { return id == boundary; });
  return place.point - depth * place.normal;
}

}  // namespace

Probe read_probe(const CaseNode& node, const Scene& scene) {
  const CaseTable table(node, {"name", "body", "point", "boundary", "depth"});
  auto bodies = tool_names(scene);
  bodies.insert(bodies.begin(), "glass");
  Probe probe{core::identifier(table.get("name")), core::choice(table.get("body"), bodies),
              read_point(table.get("point"))};
  const Body& body = probe.body == 0 ? static_cast<const Body&>(scene.glass) : scene.tools[probe.body - 1];
  if (!body.thermal)
    core::refuse(table.get("body"), fmt::format("\"{}\" carries no heat, allowed are bodies that do", body.name));
  const auto *boundary = table.find("boundary"), *depth = table.find("depth");
  if (depth && !boundary)
    core::refuse(*depth, "a depth was found, allowed only together with \"boundary\", behind which it is");
  if (!boundary) {
    if (!is_in(body, probe.point))
      core::refuse(table.get("point"), fmt::format("\"{}\" lies outside \"{}\", allowed are points inside or on its "
                                                   "outline{}",
                                                   table.get("point").text, body.name, advice(body, probe.point)));
    return probe;
  }
  const Index id = core::choice(*boundary, body.profile.boundary_names);
  probe.point = behind(body, id, probe.point, depth ? core::not_negative(*depth, dimension::length) : 0);
  if (!is_in(body, probe.point))
    core::refuse(*depth, fmt::format("({:.4g}, {:.4g}) mm, so far behind \"{}\", lies outside \"{}\", allowed are "
                                     "depths that end inside",
                                     1e3 * probe.point[0], 1e3 * probe.point[1], boundary->text, body.name));
  return probe;
}

namespace {

/// A setting of the accuracy level within what makes sense.
double read_setting(const CaseNode& item, const Setting& setting) {
  const double value =
      setting.min > 0 ? core::positive(item, setting.dimension) : core::not_negative(item, setting.dimension);
  if (value >= setting.min && value <= setting.max) return value;
  const auto shown = [&](double si) {
    return fmt::format("{:g}{}{}", si / setting.unit_size, *setting.unit ? " " : "", setting.unit);
  };
  core::refuse(item, fmt::format("{} was found, allowed are values from {} to {}", shown(value), shown(setting.min),
                                 shown(setting.max)));
}

/// Refuses a value above the one that bounds it, at whichever of the two the case gives.
void require_order(const CaseTable& table, const char* low_key, double low, const char* high_key, double high) {
  if (low <= high) return;
  const auto* item = table.find(low_key);
  core::refuse(item ? *item : table.get(high_key),
               fmt::format("{} = {:g} and {} = {:g} (SI) were found, allowed is {} up to {}", low_key, low, high_key,
                           high, low_key, high_key));
}

}  // namespace

void read_numerics(const CaseNode& node, Scene& scene) {
  Accuracy& accuracy = scene.accuracy;
  std::vector<std::string> keys;
  for (const Setting& setting : settings()) keys.push_back(setting.key);
  const CaseTable table(node, keys);
  for (const std::string& key : keys)
    if (const auto* item = table.find(key)) scene.accuracy_origin[key] = item->line > 0 ? "case" : item->file;
  for (const Setting& setting : settings())
    if (const auto* item = table.find(setting.key)) accuracy.*setting.value = read_setting(*item, setting);
  require_order(table, "min_step", accuracy.min_step, "initial_step", accuracy.initial_step);
  require_order(table, "initial_step", accuracy.initial_step, "max_step", accuracy.max_step);
  require_order(table, "skin_size", accuracy.skin_size, "surface_size", accuracy.surface_size);
}

namespace {

Flags read_flags(const CaseNode& node) {
  const CaseTable table(node, {"tool_surface_above", "glass_below", "wall_below"});
  Flags flags;
  if (const auto* item = table.find("tool_surface_above"))
    flags.tool_surface_above = core::positive(*item, dimension::temperature);
  if (const auto* item = table.find("glass_below")) flags.glass_below = core::positive(*item, dimension::temperature);
  if (const auto* item = table.find("wall_below")) flags.wall_below = core::positive(*item, dimension::length);
  return flags;
}

}  // namespace

Output read_output(const CaseNode& node) {
  const CaseTable table(node, {"interval", "times", "checkpoint_interval", "checkpoint_steps", "fill_level", "flags"});
  Output output;
  constexpr double shortest_interval = 1e-6;  // s
  if (const auto* item = table.find("interval")) {
    output.interval = core::positive(*item, dimension::time);
    if (output.interval < shortest_interval)
      core::refuse(*item, fmt::format("\"{}\" was found, allowed are intervals from 1e-6 s", item->text));
  }
  if (const auto* item = table.find("checkpoint_interval"))
    output.checkpoint_interval = core::positive(*item, dimension::time);
  if (const auto* item = table.find("fill_level")) output.fill_level = core::positive(*item, dimension::length);
  if (const auto* item = table.find("checkpoint_steps")) output.checkpoint_steps = core::count(*item);
  if (const auto* item = table.find("flags")) output.flags = read_flags(*item);
  if (const auto* times = table.find("times"))
    for (const auto& item : core::list(*times)) output.times.push_back(core::not_negative(item, dimension::time));
  return output;
}

}  // namespace parison::forming
