// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/production/lost_changes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace parison::forming {
namespace {

bool is_start_of(const Tool& tool, const std::string& key) {
  const std::string temperature = fmt::format("tool.{}.temperature", tool.name);
  return key == temperature || key.rfind(temperature + '.', 0) == 0;
}

}  // namespace

std::vector<std::string> lost_changes(const Scene& scene, const std::vector<CaseDifference>& settings) {
  std::vector<std::string> keys;
  for (const CaseDifference& setting : settings)
    if (std::any_of(scene.tools.begin(), scene.tools.end(),
                    [&](const Tool& tool) { return is_start_of(tool, setting.key); }))
      keys.push_back(setting.key);
  return keys;
}

std::string what_settled_tools_depend_on(const std::string& key) {
  const std::string tool = key.substr(0, key.find(".temperature"));
  return fmt::format(
      "changes of what heats and cools a tool, such as {0}.boundary.NAME.condition, {0}.swab, air, the glass or the "
      "stages; --cycle-time and --sets hold for all variants, and another of these is a cycle in an --output of its "
      "own",
      tool);
}

}  // namespace parison::forming
