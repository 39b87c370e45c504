// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {

using core::CaseNode;
using core::CaseTable;

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

/// More change nothing: each brings flow and heat of a step closer together.
constexpr int max_passes = 20;

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
  if (const auto* item = table.find("passes")) {
    accuracy.passes = core::count(*item);
    if (accuracy.passes > max_passes)
      core::refuse(*item, fmt::format("{} was found, allowed are up to {}", accuracy.passes, max_passes));
  }
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
