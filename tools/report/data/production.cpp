// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/production.hpp"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/io/files.hpp"
#include "tools/report/data/run_names.hpp"

namespace parison::tools {

namespace {

using Json = nlohmann::ordered_json;

/// Rows of a table, over all runs of a page, beyond which only every so many are shown.
constexpr std::size_t most_rows = 3000;

bool is_drawn(const ResultTable& table, std::size_t column) {
  const std::string& name = table.names[column];
  return table.texts[column].empty() && name.rfind("cavity_", 0) != 0;
}

/// The rows of a table that are shown, the last one always.
std::vector<std::size_t> shown_rows(const ResultTable& table, std::size_t runs) {
  const std::size_t stride = table.rows() * runs / most_rows + 1;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < table.rows(); i += stride) rows.push_back(i);
  if (!rows.empty() && rows.back() + 1 != table.rows()) rows.push_back(table.rows() - 1);
  return rows;
}

}  // namespace

Json pack_table(const ResultTable& table, std::size_t runs, PackedBytes& bytes) {
  const std::vector<std::size_t> rows = shown_rows(table, runs);
  Json names = Json::array();
  std::vector<double> numbers;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    if (!is_drawn(table, c)) continue;
    names.push_back(table.names[c]);
    for (const std::size_t row : rows) numbers.push_back(table.numbers[c][row]);
  }
  return {{"names", std::move(names)}, {"rows", rows.size()}, {"at", bytes.add_numbers(numbers)}};
}

namespace {

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
