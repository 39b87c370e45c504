// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/report/data/packed_table.hpp"

#include <nlohmann/json.hpp>

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

}  // namespace parison::tools
