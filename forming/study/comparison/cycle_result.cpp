// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/study/comparison/cycle_result.hpp"

#include <filesystem>

#include "core/io/files.hpp"
#include "core/io/json_read.hpp"

namespace parison::forming {

std::optional<CycleResult> read_cycle_result(const std::string& folder) {
  const std::string path = folder + "/cycle.json";
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(path, unreadable)) return std::nullopt;
  const core::JsonValue json = core::read_json(core::read_text(path), path);
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
