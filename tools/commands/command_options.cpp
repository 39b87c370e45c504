// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/command_options.hpp"

#include "core/case/case_error.hpp"
#include "forming/study/comparison/study_folder.hpp"
#include "tools/program/bundled_cases.hpp"

namespace parison::tools {

std::string case_of(const std::string& given) {
  if (const std::string problem = forming::results_as_case(given); !problem.empty()) throw core::CaseError(problem);
  return find_case(given);
}

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
