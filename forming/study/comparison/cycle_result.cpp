// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/cycle_result.hpp"

#include "core/io/json_read.hpp"

namespace parison::forming {

std::optional<CycleResult> read_cycle_result(const std::string& folder) {
  const auto found = core::read_json_file(folder + "/cycle.json");
  if (!found) return std::nullopt;
  const core::JsonValue& json = *found;
  CycleResult result{json.text_of("reason"), {}, {}};
  if (const core::JsonValue* changes = json.find("changes"))
    for (const core::JsonValue& change : changes->items)
      result.changes.push_back({change.text_of("key"), change.text_of("base"), change.text_of("other")});
  if (const core::JsonValue* sentences = json.find("not_possible"))
    for (const core::JsonValue& one : sentences->items)
      result.not_possible += (result.not_possible.empty() ? "" : "; ") + one.text;
  return result;
}

}  // namespace parison::forming
