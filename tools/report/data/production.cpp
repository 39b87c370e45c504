// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/production.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/io/files.hpp"
#include "tools/report/data/packed_table.hpp"
#include "tools/report/data/run_names.hpp"

namespace parison::tools {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

/// The folders of the cycles that the runs are containers of, each once.
std::vector<std::string> cycles_of(const std::vector<std::string>& folders) {
  std::vector<std::string> cycles;
  for (const std::string& folder : folders) {
    const fs::path whole = fs::absolute(folder).lexically_normal();
    const fs::path run = whole.has_filename() ? whole : whole.parent_path();
    const std::string cycle = run.parent_path().string(), name = run.filename().string();
    const bool is_container = name == "settled" || name == "first_gob" || name == "just_swabbed";
    std::error_code unreadable;
    if (is_container && fs::is_regular_file(cycle + "/cycle.json", unreadable) &&
        std::find(cycles.begin(), cycles.end(), cycle) == cycles.end())
      cycles.push_back(cycle);
  }
  return cycles;
}

}  // namespace

Json productions_of(const std::vector<std::string>& folders, PackedBytes& bytes) {
  Json productions = Json::array();
  const std::vector<std::string> cycles = cycles_of(folders), names = run_names(cycles);
  for (std::size_t i = 0; i < cycles.size(); ++i) {
    Json cycle = Json::parse(core::read_text(cycles[i] + "/cycle.json"), nullptr, false);
    if (!cycle.is_object()) continue;
    productions.push_back({{"name", names[i]},
                           {"cycle", std::move(cycle)},
                           {"over_time", pack_table(read_table(cycles[i] + "/cycle.csv"), cycles.size(), bytes)},
                           {"start_up", pack_table(read_table(cycles[i] + "/start_up.csv"), cycles.size(), bytes)}});
  }
  return productions;
}

}  // namespace parison::tools
