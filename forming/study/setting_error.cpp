// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/setting_error.hpp"

#include <fmt/format.h>

#include "core/case/given_file.hpp"

namespace parison::forming {

std::string refusal_text(const core::CaseError& error) {
  const std::string text = error.what(), option = "--set: ";
  return text.rfind(option, 0) == 0 ? text.substr(option.size()) : text;
}

std::string refusal_text(const core::CaseError& error, const std::string& option,
                         const std::vector<std::string>& assignments) {
  const std::string text = refusal_text(error);
  if (text == error.what()) return text;
  for (const std::string& assignment : assignments) {
    const std::string key(core::trimmed(assignment.substr(0, assignment.find('='))));
    if (error.key == key || error.key.rfind(key + '.', 0) == 0)
      return fmt::format("{} '{}': {}", option, assignment, text);
  }
  return fmt::format("{}: {}", option, text);
}

void refuse_setting(const core::CaseNode* set, const core::CaseError& error) {
  if (!set || refusal_text(error) == error.what()) throw error;
  for (const core::CaseNode& assignment : set->items)
    if (!error.key.empty() && assignment.text.rfind(error.key, 0) == 0) core::refuse(assignment, refusal_text(error));
  core::refuse(*set, refusal_text(error));
}

}  // namespace parison::forming
