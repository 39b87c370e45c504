// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/command_options.hpp"

namespace parison::tools {

GivenSets given_sets(const CLI::App& command, const CLI::Option* variant, const CLI::Option* set) {
  GivenSets given;
  std::size_t names = 0, sets = 0;
  for (const CLI::Option* option : command.parse_order()) {
    if (option == variant) given.variants.push_back({variant->results().at(names++), {}});
    if (option != set) continue;
    auto& overrides = given.variants.empty() ? given.before : given.variants.back().overrides;
    overrides.push_back(set->results().at(sets++));
  }
  return given;
}

}  // namespace parison::tools
