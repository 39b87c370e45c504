// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

Probe read_probe(const CaseNode& node, const Scene& scene) {
  const CaseTable table(node, {"name", "body", "point"});
  auto bodies = tool_names(scene);
  bodies.insert(bodies.begin(), "glass");
  const Probe probe{core::identifier(table.get("name")), core::choice(table.get("body"), bodies),
                    read_point(table.get("point"))};
  const Body& body = probe.body == 0 ? static_cast<const Body&>(scene.glass) : scene.tools[probe.body - 1];
  constexpr double on_surface = 1e-6;  // m
  if (!body.thermal)
    core::refuse(table.get("body"), fmt::format("\"{}\" carries no heat, allowed are bodies that do", body.name));
  if (!core::contains(body.profile, probe.point) && core::distance(body.profile, probe.point) > on_surface)
    core::refuse(table.get("point"),
                 fmt::format("\"{}\" lies outside \"{}\", allowed are points inside or on its outline",
                             table.get("point").text, body.name));
  return probe;
}

Output read_output(const CaseNode& node) {
  const CaseTable table(node, {"interval", "times", "checkpoint_interval", "checkpoint_steps"});
  Output output;
  constexpr double shortest_interval = 1e-6;  // s
  if (const auto* item = table.find("interval")) {
    output.interval = core::positive(*item, dimension::time);
    if (output.interval < shortest_interval)
      core::refuse(*item, fmt::format("\"{}\" was found, allowed are intervals from 1e-6 s", item->text));
  }
  if (const auto* item = table.find("checkpoint_interval"))
    output.checkpoint_interval = core::positive(*item, dimension::time);
  if (const auto* item = table.find("checkpoint_steps")) output.checkpoint_steps = core::count(*item);
  if (const auto* times = table.find("times"))
    for (const auto& item : core::list(*times)) output.times.push_back(core::not_negative(item, dimension::time));
  return output;
}

namespace {

/// A setting of the accuracy level within what makes sense.
double read_setting(const CaseNode& item, const Setting& setting) {
  const double value =
      setting.least > 0 ? core::positive(item, setting.dimension) : core::not_negative(item, setting.dimension);
  if (value >= setting.least && value <= setting.most) return value;
  const auto shown = [&](double si) {
    return fmt::format("{:g}{}{}", si / setting.unit_size, *setting.unit ? " " : "", setting.unit);
  };
  core::refuse(item, fmt::format("{} was found, allowed are values from {} to {}", shown(value), shown(setting.least),
                                 shown(setting.most)));
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
  std::vector<std::string> keys = {"passes", "temperature_order"};
  for (const Setting& setting : settings()) keys.push_back(setting.key);
  const CaseTable table(node, keys);
  for (const std::string& key : keys)
    if (const auto* item = table.find(key)) scene.accuracy_origin[key] = item->line > 0 ? "case" : item->file;
  for (const Setting& setting : settings())
    if (const auto* item = table.find(setting.key)) accuracy.*setting.value = read_setting(*item, setting);
  if (const auto* item = table.find("passes")) accuracy.passes = core::count(*item);
  if (const auto* item = table.find("temperature_order")) {
    accuracy.temperature_order = core::count(*item);
    if (accuracy.temperature_order > 2)
      core::refuse(*item, fmt::format("{} was found, allowed are 1 and 2", accuracy.temperature_order));
  }
  require_order(table, "min_step", accuracy.min_step, "initial_step", accuracy.initial_step);
  require_order(table, "initial_step", accuracy.initial_step, "max_step", accuracy.max_step);
  require_order(table, "skin_size", accuracy.skin_size, "surface_size", accuracy.surface_size);
}

}  // namespace parison::forming
