// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/commands/command_options.hpp"

#include <fmt/format.h>

#include "core/case/case_error.hpp"
#include "core/case/text/case_text.hpp"
#include "forming/scene/materials/material_library.hpp"
#include "forming/study/comparison/study_folder.hpp"
#include "tools/program/bundled_cases.hpp"

namespace parison::tools {

std::string case_of(const std::string& given) {
  if (const std::string problem = forming::results_as_case(given); !problem.empty()) throw core::CaseError(problem);
  return find_case(given);
}

void require_keys_once(const std::string& case_path, const std::vector<std::string>& before,
                       const std::vector<std::string>& assignments) {
  if (assignments.size() < 2) return;
  std::vector<std::string> all = before;
  all.insert(all.end(), assignments.begin(), assignments.end());
  const core::CaseFile file = forming::read_case(case_path, all);
  if (const std::string repeated = core::repeated_key(file, assignments); !repeated.empty())
    throw core::CaseError(fmt::format("--set: {}; allowed is one of them", repeated));
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
