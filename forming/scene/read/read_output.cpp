// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>

#include "forming/scene/read/scene_reading.hpp"

namespace parison::forming {

using core::CaseNode;
using core::CaseTable;
namespace dimension = core::dimension;

Output read_output(const CaseNode& node) {
  const CaseTable table(node, {"interval", "times", "checkpoint_interval", "checkpoint_steps", "fill_level"});
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
  if (const auto* times = table.find("times"))
    for (const auto& item : core::list(*times)) output.times.push_back(core::not_negative(item, dimension::time));
  return output;
}

}  // namespace parison::forming
