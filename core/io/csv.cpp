// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/csv.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/case/case_error.hpp"
#include "core/case/given_file.hpp"
#include "core/case/number.hpp"
#include "core/io/files.hpp"

namespace parison::core {

int CsvTable::find(const std::string& name) const {
  const auto at = std::find(heading.begin(), heading.end(), name);
  return at == heading.end() ? -1 : static_cast<int>(at - heading.begin());
}

double CsvTable::number(const Row& row, int column) const {
  return parse_number<double>(row.cells[static_cast<std::size_t>(column)])
      .value_or(std::numeric_limits<double>::quiet_NaN());
}

CsvTable read_csv(const std::string& path) {
  const std::string text = read_text(path);
  CsvTable table{path, "", {}, {}};
  Lines lines(text);
  for (std::string_view line; lines.next(line);) {
    if (trimmed(line).empty()) continue;
    std::vector<std::string> cells;
    for (const auto cell : split(line)) cells.emplace_back(trimmed(cell));
    if (table.heading.empty()) {
      table.heading = std::move(cells);
      table.heading_line = line;
      continue;
    }
    if (cells.size() != table.heading.size())
      throw CaseError(fmt::format("{}:{}: {} cells were found, allowed are {} as in the heading", path, lines.number(),
                                  cells.size(), table.heading.size()));
    table.rows.push_back({lines.number(), std::move(cells)});
  }
  return table;
}

}  // namespace parison::core
