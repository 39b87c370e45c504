// SPDX-License-Identifier: GPL-3.0-or-later
#include "forming/scene/read/temperature/temperature_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "core/case/given_file.hpp"

namespace parison::forming {
namespace {

using core::CaseNode;
namespace dimension = core::dimension;

constexpr std::size_t most_rows = 100000;
constexpr const char* allowed_heading = "allowed is a heading such as r_mm,z_mm,T_degC, with r, z or both";

/// What a column has: r, z or T, and its unit.
struct Column {
  char what;
  std::string unit;
};

using Row = std::array<double, 3>;  ///< r, z, T in SI; 0 where there is no such column

/// A column by its heading in small letters or capitals: r_mm, Z_MM, T_degC. Nothing where it is another one.
std::optional<Column> column_of(std::string_view heading) {
  const std::string small = core::in_small_ascii(heading);
  if (small.size() < 3 || small[1] != '_') return {};
  const std::string unit = small.substr(2);
  if (small[0] == 'r' || small[0] == 'z') return Column{small[0], unit};
  if (small[0] != 't') return {};
  return Column{'T', unit == "degc" ? "degC" : unit == "k" ? "K" : std::string(heading.substr(2))};
}

std::vector<Column> read_heading(const CaseNode& row, std::string_view line) {
  std::vector<Column> columns;
  std::string found;
  for (const auto cell : core::split(line)) {
    const auto column = column_of(core::trimmed(cell));
    if (!column || found.find(column->what) != found.npos)
      core::refuse(row, fmt::format("the heading \"{}\" was found, {}", line, allowed_heading));
    found += column->what;
    columns.push_back(*column);
  }
  if (columns.size() < 2 || found.find('T') == found.npos)
    core::refuse(row, fmt::format("the heading \"{}\" was found, {}", line, allowed_heading));
  return columns;
}

Row read_row(const CaseNode& row, std::string_view line, const std::vector<Column>& columns) {
  const auto cells = core::split(line);
  if (cells.size() != columns.size())
    core::refuse(row, fmt::format("\"{}\" has {} columns, allowed are {}", line, cells.size(), columns.size()));
  Row values{};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const char what = columns[i].what;
    const std::string text = fmt::format("{} {}", core::trimmed(cells[i]), columns[i].unit);
    const auto parsed = core::parse_quantity(text, what == 'T' ? dimension::temperature : dimension::length);
    if (!parsed.problem.empty()) core::refuse(row, parsed.problem);
    if (what == 'T' && parsed.value <= 0)
      core::refuse(row, fmt::format("\"{}\" is not above absolute zero, allowed is a temperature", text));
    values[what == 'r' ? 0 : what == 'z' ? 1 : 2] = parsed.value;
  }
  return values;
}

/// The values of a column, each once, rising.
std::vector<double> axis_of(const std::vector<Row>& rows, std::size_t column) {
  std::vector<double> values;
  values.reserve(rows.size());
  for (const Row& row : rows) values.push_back(row[column]);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

/// Where a value lies between two entries of an axis, by the first of them and the share of the second.
struct Place {
  std::size_t first;
  double share;
};
Place place_on(const std::vector<double>& axis, double value) {
  if (value <= axis.front() || axis.size() == 1) return {0, 0};
  if (value >= axis.back()) return {axis.size() - 2, 1};
  const auto above = std::upper_bound(axis.begin(), axis.end(), value) - axis.begin();
  const auto first = static_cast<std::size_t>(above - 1);
  return {first, (value - axis[first]) / (axis[first + 1] - axis[first])};
}

TemperatureGrid grid_of(const CaseNode& node, const std::vector<Row>& rows) {
  TemperatureGrid grid{axis_of(rows, 0), axis_of(rows, 1), {}};
  if (grid.r.size() * grid.z.size() != rows.size())
    core::refuse(node,
                 fmt::format("{} rows with {} different r and {} different z were found, allowed is each pair of them "
                             "once",
                             rows.size(), grid.r.size(), grid.z.size()));
  grid.T.assign(rows.size(), 0);
  const auto index = [](const std::vector<double>& axis, double value) {
    return static_cast<std::size_t>(std::lower_bound(axis.begin(), axis.end(), value) - axis.begin());
  };
  for (const Row& row : rows) grid.T[index(grid.z, row[1]) * grid.r.size() + index(grid.r, row[0])] = row[2];
  if (std::count(grid.T.begin(), grid.T.end(), 0) > 0)
    core::refuse(node, "a point was found twice, allowed is each pair of r and z once");
  return grid;
}

}  // namespace

double TemperatureGrid::operator()(const core::Point& x) const {
  const Place a = place_on(r, x[0]), b = place_on(z, x[1]);
  const auto along_r = [&](std::size_t k) {
    const double first = T[k * r.size() + a.first];
    return a.share == 0 ? first : first + a.share * (T[k * r.size() + a.first + 1] - first);
  };
  const double first = along_r(b.first);
  return b.share == 0 ? first : first + b.share * (along_r(b.first + 1) - first);
}

bool TemperatureGrid::covers(const core::Point& x, double near) const {
  const auto lies_on = [near](const std::vector<double>& axis, double value) {
    return axis.size() == 1 || (value >= axis.front() - near && value <= axis.back() + near);
  };
  return lies_on(r, x[0]) && lies_on(z, x[1]);
}

StartField read_temperature_table(const CaseNode& node, const std::string& directory) {
  const auto path = std::filesystem::path(directory) / core::text(node);
  const std::string content =
      core::read_given_file(node, path.string(), "a CSV file with its path relative to the case file");
  CaseNode row = node;
  row.file = path.string();
  std::vector<Column> columns;
  std::vector<Row> rows;
  core::Lines lines(content);
  for (std::string_view line; lines.next(line);) {
    row.line = lines.number();
    if (core::trimmed(line).empty()) continue;
    if (rows.size() == most_rows) core::refuse(row, fmt::format("allowed are up to {} rows", most_rows));
    if (columns.empty())
      columns = read_heading(row, line);
    else
      rows.push_back(read_row(row, line, columns));
  }
  if (rows.empty())
    core::refuse(node, fmt::format("no temperatures were found in \"{}\", {}", path.string(), allowed_heading));
  StartField field;
  field.source = path.filename().string();
  field.at = grid_of(node, rows);
  return field;
}

}  // namespace parison::forming
