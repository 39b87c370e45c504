// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

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
