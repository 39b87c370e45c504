// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "core/case/case_file.hpp"
#include "core/case/given_file.hpp"
#include "core/io/input_file.hpp"
#include "forming/study/law/law_fit.hpp"

namespace parison::contact {
namespace {

using core::CaseNode;
namespace dimension = core::dimension;

constexpr core::Dimension heat_flux{0, 1, -3};

const std::map<std::string, core::Dimension> known_columns{{"h", dimension::conductance},
                                                           {"q", heat_flux},
                                                           {"p", dimension::pressure},
                                                           {"eta", dimension::viscosity},
                                                           {"T_glass", dimension::temperature},
                                                           {"T_tool", dimension::temperature},
                                                           {"t", dimension::time}};

std::vector<std::string> column_names() {
  std::vector<std::string> names;
  names.reserve(known_columns.size());
  for (const auto& [name, dimension] : known_columns) names.push_back(name);
  return names;
}

struct Column {
  std::string name, unit;
};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  for (const auto cell : core::split(line)) {
    const auto first = cell.find_first_not_of(" \t\""), last = cell.find_last_not_of(" \t\"");
    cells.emplace_back(first == cell.npos ? "" : cell.substr(first, last - first + 1));
  }
  return cells;
}

[[noreturn]] void refuse_column(CaseNode at, const std::string& name, const std::string& message) {
  at.key = fmt::format("column \"{}\"", name);
  core::refuse(at, message);
}

std::vector<Column> read_heading(const CaseNode& at, const std::string& line) {
  std::vector<Column> columns;
  for (const auto& cell : cells_of(line)) {
    const auto mark = cell.find_last_of('_');
    const Column column{cell.substr(0, mark), mark == cell.npos ? "" : cell.substr(mark + 1)};
    const auto known = known_columns.find(column.name);
    if (known == known_columns.end())
      refuse_column(at, cell,
                    fmt::format("an unknown heading{}, allowed are {}, each with a unit as in p_kPa",
                                core::did_you_mean(column.name, column_names()), fmt::join(column_names(), ", ")));
    if (std::any_of(columns.begin(), columns.end(), [&](const auto& other) { return other.name == column.name; }))
      refuse_column(at, cell, fmt::format("\"{}\" was found twice, allowed is once", column.name));
    const auto probe = core::parse_quantity("1 " + column.unit, known->second);
    if (!probe.problem.empty()) refuse_column(at, cell, probe.problem);
    columns.push_back(column);
  }
  return columns;
}

using Row = std::map<std::string, double>;

void require_columns(const CaseNode& at, const std::vector<Column>& columns, bool with_viscosity) {
  const auto has = [&](const char* name) {
    return std::any_of(columns.begin(), columns.end(), [&](const auto& column) { return column.name == name; });
  };
  if (has("h") == has("q")) core::refuse(at, "one of the columns h and q is needed, not both");
  if (!has("p")) core::refuse(at, "the column p is missing");
  if (has("q") && !(has("T_glass") && has("T_tool")))
    core::refuse(at, "a heat flux q also needs the columns T_glass and T_tool");
  if (!has("eta") && !has("T_glass"))
    core::refuse(at, "the column eta is missing, or T_glass with a case that names a viscosity");
  if (!has("eta") && !with_viscosity)
    core::refuse(
        at, "the column eta is missing; to use T_glass instead give a case whose glass has a viscosity before --law");
}

Row read_row(const CaseNode& at, const std::string& line, const std::vector<Column>& columns) {
  const auto cells = cells_of(line);
  if (cells.size() != columns.size())
    core::refuse(at,
                 fmt::format("{} cells were found, allowed are {} as in the heading", cells.size(), columns.size()));
  Row row;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& [name, unit] = columns[i];
    const auto parsed = core::parse_quantity(cells[i] + " " + unit, known_columns.at(name));
    if (!parsed.problem.empty()) refuse_column(at, name, parsed.problem);
    const bool above_zero = name == "eta" || name == "T_glass" || name == "T_tool";
    const bool from_zero = name == "p" || name == "h";
    if ((above_zero && !(parsed.value > 0)) || (from_zero && parsed.value < 0))
      refuse_column(at, name,
                    fmt::format("\"{} {}\" was found, allowed are values {}", cells[i], unit,
                                above_zero ? "above zero" : "from zero"));
    row[name] = parsed.value;
  }
  return row;
}

LawMeasurement measurement(const Row& row, const std::function<double(double)>& viscosity) {
  const auto eta = row.find("eta"), h = row.find("h");
  LawMeasurement result{row.at("p"), eta != row.end() ? eta->second : viscosity(row.at("T_glass")), 0, 1};
  if (h != row.end()) {
    result.value = h->second;
  } else {
    result.value = row.at("q");
    result.drive = row.at("T_glass") - row.at("T_tool");
  }
  return result;
}

}  // namespace

std::vector<LawMeasurement> read_law_data(const std::string& path, const std::function<double(double)>& viscosity) {
  CaseNode at;
  at.file = path;
  const core::InputFile file = core::read_input_file(path);
  if (file.content.empty() && !std::filesystem::exists(path)) core::refuse(at, "no such file, allowed is a CSV file");
  if (!file.problem.empty()) core::refuse(at, file.problem);
  std::vector<Column> columns;
  std::vector<LawMeasurement> data;
  core::Lines lines(file.content);
  for (std::string_view next; lines.next(next);) {
    at.line = lines.number();
    std::string line(next);
    if (line.find_first_not_of(" \t,") == line.npos) continue;
    if (columns.empty()) {
      if (line.find(';') != line.npos && line.find(',') == line.npos)
        core::refuse(at, "semicolons between the columns were found, allowed are commas, with points in the numbers");
      columns = read_heading(at, line);
      require_columns(at, columns, static_cast<bool>(viscosity));
    } else {
      data.push_back(measurement(read_row(at, line, columns), viscosity));
    }
  }
  if (data.empty())
    core::refuse(at, "no rows were found, allowed are a heading such as p_kPa,eta_Pa.s,h_W/m2/K and rows of numbers");
  return data;
}

}  // namespace parison::contact
